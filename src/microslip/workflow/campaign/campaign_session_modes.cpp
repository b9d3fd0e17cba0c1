// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_session_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/base/error.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

/// Of the stiffness of a vibration that must not be of its joints.
constexpr double kLeastShare = 0.1;

}  // namespace

/// At those that tell a frequency in the session.
/// @param mode  from 0.
StructureSessions::StiffnessAtLevels StructureSessions::stiffness_at_levels(
    const std::string& session, std::size_t mode) const {
  StiffnessAtLevels stiffness;
  const CampaignLevels& levels = campaign_.levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const CalibratedLevel& level = found_.levels[i];
    const bool own = plan_.tests[levels.test[i]].session == session;
    if (!own || levels.mode[i] != mode + 1 || !level.found) continue;
    if (!std::isfinite(level.measured_frequency)) continue;
    std::vector<double>& of_level = stiffness.emplace_back();
    for (std::size_t j = 0; j < structure_.joints().size(); ++j) {
      of_level.push_back(secant_stiffness(structure_.joints()[j].joint, level.joints[j].amplitude));
    }
  }
  return stiffness;
}

std::vector<double> StructureSessions::mean_of(const StiffnessAtLevels& levels) const {
  std::vector<double> means(structure_.joints().size(), 0.0);
  for (const std::vector<double>& of_level : levels) {
    for (std::size_t j = 0; j < means.size(); ++j) {
      means[j] += of_level[j] / static_cast<double>(levels.size());
    }
  }
  return means;
}

/// Of the vibrations that the levels of a session tell, by the joints at these.
std::vector<StructureOffset> StructureSessions::determined_offsets(
    const std::string& session) const {
  std::vector<StructureOffset> offsets;
  for (std::size_t mode = 0; mode < structure_.linear().vibrations(); ++mode) {
    const auto determined = campaign_.sessions.determined_offset(session, mode + 1);
    if (!determined) continue;
    StructureOffset one{.mode = mode,
                        .offset = determined->first,
                        .joint_stiffness = mean_of(stiffness_at_levels(session, mode))};
    if (one.offset != 0.0 || share_of_modes(structure_, one) >= kLeastShare) {
      offsets.push_back(std::move(one));
    }
  }
  return offsets;
}

void StructureSessions::require_shares(const std::string& session,
                                       const std::vector<StructureOffset>& determined) const {
  for (const StructureOffset& one : determined) {
    const double share = share_of_modes(structure_, one);
    if (share >= kLeastShare) continue;
    throw InputError(fmt::format("session_offsets: session {}, mode {}", session, one.mode + 1),
                     fmt::format("{:.2g} % of its stiffness without the joints", 100.0 * share),
                     "must be 10 % or more: an offset is one of the structure, not of its joints",
                     "Leave session_offsets out, or predict no test of this session.");
  }
}

/// An offset of the structure is less at levels where its joints are stiff, and one of all its
/// stiffness is not: by this they differ, rms over the levels, 1. Which of them holds is unknown.
/// @param moved  the structure with the offset.
double StructureSessions::change_over_levels(const std::string& session,
                                             const StructureOffset& determined,
                                             const JointedStructure& moved) const {
  const StiffnessAtLevels at_levels = stiffness_at_levels(session, determined.mode);
  double squares = 0.0;
  for (const std::vector<double>& stiffness : at_levels) {
    const StructureOffset there{.mode = determined.mode, .joint_stiffness = stiffness};
    const double offset =
        std::log(secant_frequency(moved, there) / secant_frequency(structure_, there));
    squares += std::pow(offset - determined.offset, 2);
  }
  return std::sqrt(squares / static_cast<double>(at_levels.size()));
}

SessionModes StructureSessions::modes_in(const std::string& session,
                                         const std::vector<double>& scatter) const {
  const auto [others, others_std] = campaign_.sessions.offset_of_others(session);
  const std::vector<StructureOffset> determined = determined_offsets(session);
  require_shares(session, determined);
  const ModalOffsets found = modal_offsets(structure_, determined, others);
  const JointedStructure moved = with_modal_offsets(structure_, found.offset);
  std::vector<double> deviation;  // of each that is determined
  for (const StructureOffset& one : determined) {
    const double own = campaign_.sessions.determined_offset(session, one.mode + 1)->second;
    deviation.push_back(
        std::hypot(own, scatter[one.mode], change_over_levels(session, one, moved)));
  }
  SessionModes modes{.offset = found.offset, .deviation = scatter};
  for (std::size_t i = 0; i < scatter.size(); ++i) {
    double variance = found.left[i] * (others_std * others_std + scatter[i] * scatter[i]);
    for (std::size_t m = 0; m < determined.size(); ++m) {
      variance += std::pow(found.by_measured[i][m] * deviation[m], 2);
    }
    modes.deviation[i] = std::sqrt(variance);
  }
  return modes;
}

std::vector<Warning> StructureSessions::warnings_of_change() const {
  std::vector<Warning> warnings;
  if (plan_.frequency == FrequencyOfLevels::kIgnore) return warnings;
  for (const std::string& session : plan_.sessions()) {
    for (const StructureOffset& one : determined_offsets(session)) {
      const double share = share_of_modes(structure_, one);
      if (one.offset == 0.0 || share < kLeastShare) continue;
      std::vector<double> offsets(structure_.linear().size(), one.offset / share);
      std::fill_n(offsets.rbegin(), structure_.linear().static_modes(), 0.0);
      const JointedStructure moved = with_modal_offsets(structure_, offsets);
      const double change = change_over_levels(session, one, moved);
      const double scatter = campaign_.sessions.find(session, one.mode + 1)->frequency_scatter;
      if (!(change > scatter)) continue;
      warnings.push_back(
          {"offset_of_another_kind",
           fmt::format(
               "the offset of session {}, mode {}, {:+.2g} %, is treated as one factor on all its "
               "frequencies when the joints are identified. An offset of the structure without its "
               "joints changes by {:.2g} % over the levels, more than the scatter of {:.2g} % of "
               "their frequencies: the joints may be in error by more than their bands. frequency "
               "= \"ignore\" identifies them from their losses alone.",
               session, one.mode + 1, 100.0 * one.offset, 100.0 * change, 100.0 * scatter)});
    }
  }
  return warnings;
}

}  // namespace microslip
