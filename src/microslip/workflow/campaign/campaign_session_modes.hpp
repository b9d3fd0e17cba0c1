// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "microslip/workflow/campaign/campaign_joints.hpp"

/// @file
/// Frequency offsets of a session as offsets of a structure with several joints. Internal to
/// workflow.

namespace microslip {

/// The structure of a model in the sessions of a campaign that fits offsets: what sets its
/// frequencies off is taken to be in the structure, and not in its joints.
class StructureSessions {
 public:
  /// @param plan       what tests and sessions there are. @param structure  with the joints found.
  /// @param found      with its levels, those of the campaign.
  /// @param campaign   levels and sessions are taken from. All four are kept by reference.
  StructureSessions(const CampaignFile& plan, const JointedStructure& structure,
                    const CalibrationResult& found, const DoneCampaign& campaign)
      : plan_(plan), structure_(structure), found_(found), campaign_(campaign) {}

  /// As CampaignJoints::modes_in().
  [[nodiscard]] SessionModes modes_in(const std::string& session,
                                      const std::vector<double>& scatter) const;

  /// `offset_of_another_kind` of each mode and session whose offset, as one of the structure
  /// without its joints, would change by more over the levels than their frequencies scatter: the
  /// joints are found as if it were one factor of all of them.
  [[nodiscard]] std::vector<Warning> warnings_of_change() const;

 private:
  /// Of each joint, N/m, at each level of a mode.
  using StiffnessAtLevels = std::vector<std::vector<double>>;

  [[nodiscard]] StiffnessAtLevels stiffness_at_levels(const std::string& session,
                                                      std::size_t mode) const;
  [[nodiscard]] std::vector<double> mean_of(const StiffnessAtLevels& levels) const;
  [[nodiscard]] std::vector<StructureOffset> determined_offsets(const std::string& session) const;
  void require_shares(const std::string& session,
                      const std::vector<StructureOffset>& determined) const;
  [[nodiscard]] double change_over_levels(const std::string& session,
                                          const StructureOffset& determined,
                                          const JointedStructure& moved) const;

  const CampaignFile& plan_;
  const JointedStructure& structure_;
  const CalibrationResult& found_;
  const DoneCampaign& campaign_;
};

}  // namespace microslip
