// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/identify/method_comparison.hpp"
#include "microslip/report/report_document.hpp"
#include "microslip/report/scales.hpp"
#include "microslip/workflow/experiment_results.hpp"
#include "microslip/workflow/sampled_curves.hpp"

/// @file
/// The sections of the report of a test. Internal to report.

namespace microslip {

/// The levels by all methods, for comparison with the joint of the results. Nothing where there are
/// too few levels or no stiffness.
[[nodiscard]] std::optional<MethodComparison> compare_methods(const ExperimentResults& results);

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

/// What the joint of the results and the true one give over the amplitudes of the levels.
/// @param value    of a joint at an amplitude in m, in the unit of the axis.
/// @param damping  what a linear damping of 1 J/m² adds to it; nothing where it adds none.
[[nodiscard]] std::vector<ReportTrace> curves_of_joints(
    const ExperimentResults& results, const std::function<double(const Joint&, double)>& value,
    const std::function<double(double)>& damping = {});

/// D of the levels less the linear damping βA² that the joint was identified with, J.
[[nodiscard]] std::vector<double> net_dissipation(const ExperimentResults& results);

/// σ of D less that of the joint, J: √(σ_D² + (D′ σ_A)²), as the identification weights the levels.
/// Empty where a level has no σ_D.
[[nodiscard]] std::vector<double> dissipation_deviations(const ExperimentResults& results);

/// Values at the levels, SI.
struct MeasuredPoints {
  std::vector<double> value;
  std::vector<double> std;  ///< empty where it is not known
};

/// η = D/(π k_eq A²) of the levels, with D less the linear damping beside the joint; its relative
/// variance is that of D and of k_eq and four times that of A. Empty where k_eq was not measured.
[[nodiscard]] MeasuredPoints measured_loss_factor(const ExperimentResults& results);

/// D of the levels less that of the joint of the results.
struct Misfit {
  double rms = 0.0;            ///< over the deviations, or relative to D, 1
  bool in_deviations = false;  ///< which of the two
};
[[nodiscard]] Misfit misfit_of_levels(const ExperimentResults& results);

/// D of the levels less that of the joint and its linear damping, J, over a scale that each level
/// has.
[[nodiscard]] std::vector<double> residuals_over(const ExperimentResults& results,
                                                 const std::vector<double>& scale);

/// The strokes of what is known and of what was found, as in all figures: where they coincide the
/// thin broken line of the truth lies on the broad one of the joint.
inline constexpr Stroke kTruth = {.colour = kVermillion, .style = LineStyle::kDashed, .width = 1.4};
inline constexpr Stroke kFound = {.colour = kBlue, .width = 3.2};
inline constexpr const char* kFoundName = "identified joint";

/// The last part of a path.
[[nodiscard]] std::string_view file_name(std::string_view path);

/// Marks at the levels. @param value  one a level; @param std  the same or empty.
[[nodiscard]] ReportTrace at_levels(const ExperimentResults& results, std::string name,
                                    std::vector<double> value, std::vector<double> std, int colour);

}  // namespace microslip
