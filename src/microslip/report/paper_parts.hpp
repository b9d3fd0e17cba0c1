// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/report/identification_figures.hpp"
#include "microslip/report/paper_figures.hpp"

/// @file
/// What several figures for papers need. Internal to report.

namespace microslip {

/// @throws InputError  "what = missing; rule".
[[noreturn]] void throw_missing(const char* what, const char* rule);

/// @throws InputError  where there is none.
[[nodiscard]] const IdentifiedJoint& joint_of(const ExperimentResults& results);
[[nodiscard]] const MeasuredLevels& levels_of(const ExperimentResults& results);

/// In legends. A joint that was not identified covers no levels.
[[nodiscard]] const char* name_of(const IdentifiedJoint& found);

/// The truth, and the others of the options.
[[nodiscard]] std::vector<DrawnJoint> drawn_others(const ExperimentResults& results,
                                                   const PaperOptions& options);

/// With the joint of the results before them: dashed lines can be seen on its solid one.
[[nodiscard]] std::vector<DrawnJoint> drawn_joints(const ExperimentResults& results,
                                                   const PaperOptions& options);

/// Where the last slider slips, m. @throws InputError  where none does.
[[nodiscard]] double macroslip_amplitude(const Joint& joint);

/// Whether an axis of amplitudes is logarithmic. @param suits  where the options leave it open.
[[nodiscard]] bool is_log(const PaperOptions& options, bool suits);

}  // namespace microslip
