// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/density.hpp"

/// @file
/// Comparison of an identified density with a known one, as of a simulated test.

namespace microslip {

/// A share of the range 0 … kA_max that the levels reach, relative, 1; 0 ≤ from < to ≤ 1.
struct CoveredRange {
  double from = 0.05;  ///< of kA_max, 1
  double to = 0.95;    ///< of kA_max, 1
};

/// ‖φ − φ_true‖₂/‖φ_true‖₂ over the range, at 2001 points of equal distance; atoms do not take
/// part.
/// @throws InputError  for an invalid range, or where the true density is 0 all over it.
[[nodiscard]] double density_error(const Identification& found, const SlipDensity& truth,
                                   CoveredRange range = {});

/// The error of a density that the levels determine up to a slip force.
/// @param density  φ, compared without its atoms.
/// @param reach    kA_max, N.
/// @param truth    the density that is known.
/// @param range    over which the two are compared.
/// @throws InputError  as above.
[[nodiscard]] double density_error(const SlipDensity& density, double reach,
                                   const SlipDensity& truth, CoveredRange range = {});

/// The error of a density at points, linear between them and with the end values beyond; it may be
/// negative, as that of SplineDensityResult.
/// @param slip_force  f*, N; rising, one at least.
/// @param density     1/N; one per slip force.
/// @param reach       kA_max, N.
/// @param truth       the density that is known.
/// @param range       over which the two are compared.
/// @throws InputError  as above, and where the numbers of points differ or there is none.
[[nodiscard]] double density_error(const std::vector<double>& slip_force,
                                   const std::vector<double>& density, double reach,
                                   const SlipDensity& truth, CoveredRange range = {});

/// Share of the range on which the true density lies within the band, 1, at the same points.
/// @throws InputError  for an invalid range, or an identification without band.
[[nodiscard]] double band_coverage(const Identification& found, const SlipDensity& truth,
                                   CoveredRange range = {});

}  // namespace microslip
