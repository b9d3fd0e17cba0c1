// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/workflow/campaign/campaign_result.hpp"
#include "microslip/workflow/campaign/campaign_run.hpp"

/// @file
/// How the joints of a campaign are found, whatever it is of. Internal to workflow.

namespace microslip {

/// Comment at the beginning of the files of a campaign.
struct CampaignComment {
  std::string text = {};               ///< provenance, without warnings
  std::vector<InputHash> inputs = {};  ///< campaign, structure and tests
};

/// The modes of a structure in a session, one entry each.
struct SessionModes {
  std::vector<double> offset = {};     ///< of ln ω_i, 1
  std::vector<double> deviation = {};  ///< its standard deviation, with that of the frequency, 1
};

/// Finds joints from the tests of a campaign, and gives the model that predicts by them.
class CampaignJoints {
 public:
  CampaignJoints() = default;
  CampaignJoints(const CampaignJoints&) = delete;
  CampaignJoints& operator=(const CampaignJoints&) = delete;
  virtual ~CampaignJoints() = default;

  /// Reads the tests to identify from and finds the joints: fills in levels, sessions, what was
  /// found at the levels, the summary and the warnings.
  virtual void identify(const Progress& progress, DoneCampaign& all) = 0;
  /// Which of the data contradict which.
  [[nodiscard]] virtual std::vector<LeftOut> leave_out(const DoneCampaign& all,
                                                       const Progress& progress) const = 0;
  /// The model with the joints found, without offsets.
  /// @param all  with its sessions. @param warnings  get those of it.
  [[nodiscard]] virtual ModelFile model(const DoneCampaign& all,
                                        std::vector<Warning>& warnings) const = 0;
  /// Effect of frequency offsets of a session on the modes of the model.
  /// @param session  by name. @param model  that model() gave. @param all  with its sessions.
  /// @param scatter  standard deviation of a frequency beside that of its offset, 1; one per mode.
  /// @throws InputError  where no modes have these frequencies with the joints.
  [[nodiscard]] virtual SessionModes modes_in(const std::string& session, const ModelFile& model,
                                              const DoneCampaign& all,
                                              const std::vector<double>& scatter) const = 0;
  /// The draws of its joints; nothing of one without.
  [[nodiscard]] virtual std::vector<std::optional<JointSamples>> samples() const = 0;
  /// Its own files. @param all  with all its warnings.
  [[nodiscard]] virtual std::vector<ResultFile> files(const DoneCampaign& all) = 0;
};

/// The paths and kinds of the files that CampaignJoints::files() gives.
/// @throws FileError, FormatError, InputError  as the reader of what it is of.
[[nodiscard]] std::vector<ResultFile> planned_files_of_rig(const CampaignRun& run,
                                                           const CampaignFile& plan);
[[nodiscard]] std::vector<ResultFile> planned_files_of_model(
    const CampaignRun& run, const OpenedCampaign& opened);  ///< as above

/// @param run      kept by reference. @param opened  kept by reference.
/// @param comment  of the files.
[[nodiscard]] std::unique_ptr<CampaignJoints> joints_of_rig(const CampaignRun& run,
                                                            const OpenedCampaign& opened,
                                                            CampaignComment comment);
[[nodiscard]] std::unique_ptr<CampaignJoints> joints_of_model(
    const CampaignRun& run, const OpenedCampaign& opened, CampaignComment comment);  ///< as above

}  // namespace microslip
