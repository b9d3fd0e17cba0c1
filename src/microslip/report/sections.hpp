// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/identify/method_comparison.hpp"
#include "microslip/report/report_document.hpp"
#include "microslip/report/scales.hpp"
#include "microslip/workflow/experiment_results.hpp"
#include "microslip/workflow/level_quantities.hpp"
#include "microslip/workflow/sampled_curves.hpp"

/// @file
/// The sections of the report of a test. Internal to report.

namespace microslip {

[[nodiscard]] ReportSection summary_section(const ExperimentResults& results,
                                            const std::optional<MethodComparison>& methods);
[[nodiscard]] ReportSection levels_section(const ExperimentResults& results);
[[nodiscard]] ReportSection signals_section(const ExperimentResults& results);
[[nodiscard]] ReportSection energies_section(const ExperimentResults& results);
[[nodiscard]] ReportSection density_section(const ExperimentResults& results,
                                            const std::optional<MethodComparison>& methods);
[[nodiscard]] ReportSection loops_section(const ExperimentResults& results,
                                          const std::optional<MethodComparison>& methods);
[[nodiscard]] ReportSection stiffness_section(const ExperimentResults& results);
[[nodiscard]] ReportSection responses_section(const ExperimentResults& results);
[[nodiscard]] ReportSection predictions_section(const ExperimentResults& results);
[[nodiscard]] ReportSection rig_section(const ExperimentResults& results);
[[nodiscard]] ReportSection provenance_section(const ExperimentResults& results);

// What several sections need.

/// The axis of the joint amplitude, in µm. @param log  at first.
[[nodiscard]] ReportAxis amplitude_axis(bool log = false);

/// A quantity of the joint of the results and of the true one over the amplitudes of the levels.
/// @param unit    of the axis, SI.
/// @param damped  with the linear damping βA² beside them.
[[nodiscard]] std::vector<ReportTrace> curves_of_joints(const ExperimentResults& results,
                                                        JointQuantity quantity, double unit = 1.0,
                                                        bool damped = false);

/// The strokes of what is known and of what was found, as in all figures: where they coincide the
/// thin broken line of the truth lies on the broad one of the joint.
inline constexpr Stroke kTruth = {.colour = kVermillion, .style = LineStyle::kDashed, .width = 1.4};
inline constexpr Stroke kFound = {.colour = kBlue, .width = 3.2};
inline constexpr const char* kFoundName = "identified joint";

/// Marks at the levels. @param value  one a level; @param std  the same or empty.
[[nodiscard]] ReportTrace at_levels(const ExperimentResults& results, std::string name,
                                    std::vector<double> value, std::vector<double> std, int colour);

}  // namespace microslip
