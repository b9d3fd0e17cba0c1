// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/workflow/results/experiment_results.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

/// @file
/// Quantities of the levels of a test, alone and compared with the joint of its results. Vectors
/// have one entry per level.

namespace microslip {

/// D of the levels less the linear damping βA² that the joint was identified with, J.
[[nodiscard]] std::vector<double> net_dissipation(const ExperimentResults& results);

/// σ of D less that of the joint, J, as the identification weights the levels: LevelEvidence. Empty
/// where a level has no σ_D.
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

/// residuals_over() D itself, 1, with σ_D/D beside them; 0 where that is no number.
[[nodiscard]] MeasuredPoints relative_residuals(const ExperimentResults& results);

/// W_lin/W_ext of levels that have both energies, 1. [AR14 Fig. 8]
[[nodiscard]] std::vector<double> linear_share(const MeasuredLevels& levels);

/// ζ = W/(4πE) with the measured W and the E of the predicted backbone at that amplitude, which is
/// that of the response and the mode and hardly depends on the joint. E/A² is interpolated. Empty
/// where the levels or the prediction tell too little.
[[nodiscard]] std::vector<double> measured_damping(const ExperimentResults& results);

/// D/D_exact − 1 over A, m, of levels whose record a virtual test knows, by the names of files.
/// @param levels  reduced. @param exact  of the virtual test.
[[nodiscard]] Curve reduction_errors(const MeasuredLevels& levels, const MeasuredLevels& exact);

/// From the lowest to the highest level in equal ratios, m: where curves beside levels are sampled.
[[nodiscard]] std::vector<double> curve_amplitudes(const Levels& levels);

}  // namespace microslip
