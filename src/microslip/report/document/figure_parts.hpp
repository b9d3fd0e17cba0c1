// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/report/document/figure_options.hpp"
#include "microslip/workflow/results/experiment_results.hpp"
#include "microslip/workflow/results/level_quantities.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

/// @file
/// Parts that several figures of a test share. Internal to report.

namespace microslip {

/// @throws InputError  "what = missing; rule".
[[noreturn]] void throw_missing(const char* what, const char* rule);

/// @throws InputError  where there is none.
[[nodiscard]] const IdentifiedJoint& joint_of(const ExperimentResults& results);
[[nodiscard]] const MeasuredLevels& levels_of(const ExperimentResults& results);

/// The strokes of what was found and of what is known: where they coincide the thin broken line of
/// the truth lies on the broad one of the joint.
inline constexpr Stroke kFound = {.colour = kBlue, .width = 2.4};
inline constexpr Stroke kTruth = {.colour = kVermillion, .style = LineStyle::kDashed, .width = 1.4};

/// Legends of predictions by the joints of a rig.
inline constexpr const char* kPredictedByJoint = "predicted by the joint";
inline constexpr const char* kPredictedByTruth = "by the true joint";

/// Name of the joint in legends. A joint that was not identified covers no levels.
[[nodiscard]] const char* joint_name(const IdentifiedJoint& found);

/// A joint that is drawn beside others.
struct ShownJoint {
  std::string name;    ///< in the legend
  Joint joint;         ///< whose curve is drawn
  Stroke stroke = {};  ///< of its line
};

/// The true joint, and the other joints of the options.
[[nodiscard]] std::vector<ShownJoint> drawn_others(const ExperimentResults& results,
                                                   const FigureOptions& options);

/// The joint of the results and drawn_others(): dashed lines can be seen on its solid one.
[[nodiscard]] std::vector<ShownJoint> drawn_joints(const ExperimentResults& results,
                                                   const FigureOptions& options);

/// Amplitude at which the last slider slips, m. @throws InputError  where none does.
[[nodiscard]] double macroslip_amplitude(const Joint& joint);

/// Whether an axis of amplitudes is logarithmic. @param suits  where the options leave it open.
[[nodiscard]] bool is_log(const FigureOptions& options, bool suits);

// Layers in SI units, before show_x() and show_y().

/// Values at the levels, over A.
[[nodiscard]] PointLayer at_levels(const MeasuredLevels& levels, const MeasuredPoints& measured,
                                   std::string legend, int colour = kBlack);

/// A quantity of the joint, of the true one and of others over the amplitudes of the levels, of
/// the range that the identification covered, or up to where the joint slips.
void add_curves(Figure& figure, const ExperimentResults& results, const FigureOptions& options,
                JointQuantity quantity);

/// D + βA²: what the levels hold where linear damping was identified beside the joint.
void add_with_damping(Figure& figure, const ExperimentResults& results);

/// The axis of the joint amplitude; the reader of a page may change its scale.
void show_amplitude(Figure& figure, const FigureOptions& options, bool suits_log);

/// The axis of the response at the exciter, in the unit of the options.
/// @throws InputError  for a unit that is none of acceleration.
void show_response(Figure& figure, const FigureOptions& options, bool suits_log);

}  // namespace microslip
