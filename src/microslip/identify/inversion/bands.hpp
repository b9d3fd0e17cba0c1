// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/identify/inversion/inversion.hpp"

namespace microslip {

/// How density_bands() draws from DensityPosterior.
struct BandOptions {
  std::size_t samples = 1000;  ///< ≥ 20
  double confidence = 0.95;    ///< nominal coverage, in (0, 1)
  std::uint64_t seed = 1;      ///< of all samples

  Progress progress = {};                      ///< reports the samples done of all; may cancel
  Execution execution = Execution::threads();  ///< of the samples

  /// @throws InputError  naming the option that breaks its rule.
  void check() const;
};

/// Pointwise band of a density: at each slip force by itself. Its lower edge as a whole is no
/// joint, nor is its upper edge: no sample follows either, and their areas may lie far outside of
/// `area`.
struct DensityBands {
  double confidence = 0.0;    ///< nominal coverage, 1
  std::vector<double> lower;  ///< 1/N; one per knot of the result
  std::vector<double> upper;  ///< 1/N
  /// Of Φ0, 1. Of few levels it goes down to least_area(): each density ≥ 0 that is drawn adds to
  /// the area, and none of them is 0 wherever the truth is.
  std::pair<double, double> area;
  std::pair<double, double> linear_damping;  ///< of β, J/m²; zeros where it was not fitted
  std::pair<double, double> atom_weight;     ///< 1; zeros where there is none
  std::size_t samples = 0;                   ///< number drawn
  /// Equivalent number of independent draws, for the φ at which it is least; some 100 determine
  /// the ends of a 95 % band to a sixth of its width.
  double effective_samples = 0.0;
};

/// Pointwise quantiles of the draws 0 … samples − 1: with as many draws below as above the
/// band, or from 0 on where that is narrower; widened to the estimate where they do not contain it,
/// and so are the intervals of Φ0, β and the weight of the atom;
/// on all processors; the same on any number of them.
/// @throws InputError  where an option breaks its rule, or the result is not one of invert().
/// @throws Cancelled   when progress returns false.
[[nodiscard]] DensityBands density_bands(const InversionResult& result, const BandOptions& options);

/// Bands of draws that were made before.
/// @param result      whose posterior was drawn.
/// @param samples     of its posterior; 20 or more.
/// @param confidence  in (0, 1).
/// @throws InputError  as above.
[[nodiscard]] DensityBands density_bands(const InversionResult& result,
                                         std::span<const DensitySample> samples, double confidence);

}  // namespace microslip
