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

  Progress progress = {};                      ///< told of the samples done of all; may cancel
  Execution execution = Execution::threads();  ///< of the samples

  /// @throws InputError  naming the option that breaks its rule.
  void check() const;
};

/// Pointwise band of a density: at each slip force by itself. Its lower edge as a whole is no
/// joint, nor is its upper edge: no sample follows either, and their areas may lie far outside of
/// `area`.
struct DensityBands {
  double confidence = 0.0;                   ///< nominal coverage, 1
  std::vector<double> lower;                 ///< 1/N; one a knot of the result
  std::vector<double> upper;                 ///< 1/N
  std::pair<double, double> area;            ///< of Φ0, 1
  std::pair<double, double> linear_damping;  ///< of β, J/m²; zeros where it was not fitted
  std::pair<double, double> atom_weight;     ///< 1; zeros where there is none
  std::size_t samples = 0;                   ///< that were drawn
  /// Independent draws that know as much as these, of the φ at which that is least; some 100 know
  /// the ends of a 95 % band to a sixth of its width.
  double effective_samples = 0.0;
};

/// Pointwise quantiles of the draws 0 … samples − 1: with as many draws below as above the band, or
/// from 0 on where that is narrower; widened to the estimate where they do not hold it; on all
/// processors; the same on any number of them.
/// @throws InputError  where an option breaks its rule, or the result is none of invert().
/// @throws Cancelled   when progress says so.
[[nodiscard]] DensityBands density_bands(const InversionResult& result, const BandOptions& options);

/// The same of draws that were made before.
/// @param result      that they are of.
/// @param samples     of its posterior; 20 or more.
/// @param confidence  in (0, 1).
/// @throws InputError  likewise.
[[nodiscard]] DensityBands density_bands(const InversionResult& result,
                                         std::span<const DensitySample> samples, double confidence);

}  // namespace microslip
