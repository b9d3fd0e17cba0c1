// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/smoothing/signed_density.hpp"
#include "microslip/identify/smoothing/smoothing_spline.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// Smoothing of D(A). A smoothing factor p is that of csaps with the amplitude in its given unit:
/// MatlabP{0.965, 1e-6} for p = 0.965 found with A in µm.
struct SplineDensityOptions {
  /// By default GCV that charges 1.4 for a degree of freedom: with plain GCV about one density in
  /// ten is almost unsmoothed, for 12 levels as for 90.
  Smoothing smoothing = Gcv{.edf_factor = 1.4};
};

/// Result of density_by_spline().
struct SplineDensityResult {
  double stiffness = 0.0;  ///< k, N/m
  SignedDensity density;   ///< at each distinct level; zero at the first and the last
  /// The fit of D(A): A in m, D in J, λ in m³; its Summary is that of the method.
  SmoothingSplineResult fit;
  bool weighted = false;          ///< whether levels have weights 1/σ² over their mean; else 1
  std::vector<Warning> warnings;  ///< those of the fit, and density_negative

  /// φ(f*) between the levels too, 1/N; zero outside of them. @param slip_force  f*, N.
  [[nodiscard]] double density_at(double slip_force) const;
};

/// The density from a cubic smoothing spline D̂ of D(A): φ(kA) = D̂″(A)/(4k²A). [AR14 (9), Fig. 9]
///
/// Weights are 1/σ², divided by their mean over the levels, where `dissipation_std` is given and
/// all positive, and 1 otherwise; so λ is in m³ and does not depend on the unit of D. A natural
/// spline has D̂″ = 0 at both ends, whatever the joint: the first and last few values are too
/// low.
///
/// One λ serves all amplitudes. Where σ is in proportion to D, the weights make the curve follow
/// the low levels closely, and φ is noisy there; without `dissipation_std` the opposite holds.
/// @param levels     with their errors; at least 3 distinct (4 for Gcv).
/// @param stiffness  k, N/m; positive and finite.
/// @param options    how D(A) is smoothed.
/// @throws InputError  naming the value that breaks a rule.
[[nodiscard]] SplineDensityResult density_by_spline(const LevelEvidence& levels, double stiffness,
                                                    const SplineDensityOptions& options = {});

}  // namespace microslip
