// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "microslip/identify/methods/method_comparison.hpp"
#include "microslip/workflow/results/experiment_results.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

/// @file
/// Results of other methods and other smoothing from the levels of a test.

namespace microslip {

/// The levels by all methods, for comparison with the joint of the results. Nothing where there are
/// too few levels or no stiffness.
/// @throws InputError  where the methods refuse the levels.
[[nodiscard]] std::optional<MethodComparison> compare_methods(const ExperimentResults& results);

/// D′ over the amplitude, N over m, of levels less the linear damping.
struct MeasuredSlopes {
  Curve differences;  ///< between neighbouring levels
  Curve spline;       ///< of the smoothing spline
};

/// @param methods  of two levels or more.
[[nodiscard]] MeasuredSlopes measured_slopes(const MethodComparison& methods);

/// Result with a multiple of the smoothing parameter λ.
struct VariedSmoothing {
  double factor;         ///< of λ; 1 is the chosen one
  Identification found;  ///< with it
};

/// From stiff to flexible, λ a hundred times larger to a hundred times smaller.
/// @param methods  with an inversion.
[[nodiscard]] std::vector<VariedSmoothing> varied_inversions(const MethodComparison& methods);

/// The spline with λ a hundred times smaller, as it is, and a hundred times larger.
/// [AR14 Fig. 10]
/// @param methods  of the levels.
[[nodiscard]] std::vector<VariedSmoothing> varied_splines(const MethodComparison& methods);

}  // namespace microslip
