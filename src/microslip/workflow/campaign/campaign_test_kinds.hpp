// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/workflow/campaign/campaign_run.hpp"
#include "microslip/workflow/compare/comparison_reading.hpp"

/// @file
/// A test of a campaign by its kind: what it may be, its levels, how it is read to be predicted.
/// Internal to workflow.

namespace microslip {

/// Modes of a beam in the model of a campaign, as of the subcommand `model`.
inline constexpr std::size_t kModesOfCampaign = 7;

/// Whether what the campaign says of a test fits its file, its use and what it is of.
/// @throws InputError  naming the test: for a kind that its file is not of, a file that cannot be
///                     identified from or predicted, keys that would do nothing.
void check_campaign_test(const CampaignTest& test, const TestFile& file, CampaignSubject subject);

/// The levels of a test that is no table of them.
struct ReducedCampaignTest {
  std::string text = {};               ///< of NAME_levels.csv
  std::vector<Warning> warnings = {};  ///< of the readers and the reduction
  bool converged = true;               ///< of a ring-down: followed to the end or to the noise
};

/// Reduces steady records and stepped sines by the rig, as reduce_recordings(); the closed cycles
/// of loops, as find_record_levels(); and a ring-down in the first mode, as reduce_modal_decay()
/// finds it, with D = 2πζω²mx² − πΣη_iω_i²q_i² and the amplitude |Σψ_iq_i|/(1 + kc) at a
/// displacement x of the (first) sensor. The shape is that of the mode with a joint that has
/// softened until its frequency is ω: q_i ∝ ψ_i/(ω_i² − ω²), m = Σq_i²/x²; as stuck where ω is
/// higher than that. ω_i, η_i, ψ_i (across the joint) and c (the axial compliance) are those of the
/// rig with its joint stuck. A frequency of the rig that is wrong is taken for slip; of a rig of
/// one mode the shape is fixed.
/// @param campaign  whose structure and k count. @param number  of the test in it, from 0.
/// @param command   of the comment in the table. @param progress  reports records; may cancel.
/// @throws FileError, FormatError, InputError, Cancelled  as these; where all loss is that of the
///     rig without its joint.
[[nodiscard]] ReducedCampaignTest reduce_campaign_test(const OpenedCampaign& campaign,
                                                       std::size_t number,
                                                       const std::string& command,
                                                       const Progress& progress);

/// The same for levels of modes: of steady records as reduce_modal_levels(), of a ring-down as
/// reduce_modal_decay(), all modes of it or the one that is named.
[[nodiscard]] ReducedCampaignTest reduce_modal_test(const OpenedCampaign& campaign,
                                                    std::size_t number, const std::string& command,
                                                    const Progress& progress);

/// Errors of a test name it: "test 'blow': sensor acc1=tip", without the marks of an
/// option.
template <typename Call>
auto of_campaign_test(const CampaignTest& test, const Call& call) {
  try {
    return call();
  } catch (const InputError& error) {
    std::string name(error.name());
    std::erase(name, '`');
    throw error.renamed("test '" + test.name + "': " + name);
  }
}

/// How a test is read to be predicted.
[[nodiscard]] TestReading campaign_reading(const CampaignTest& test);

}  // namespace microslip
