// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/base/random.hpp"

namespace microslip {

/// Prior of the standard deviation σ of the logarithm of a quantity between assemblies:
///
///     p(σ) ∝ 1/((s₀ + σ)(1 + (σ/S)²)),   s₀ = 0.005, S = 0.5.
///
/// From half a per cent to a factor of e^½ no order of magnitude is likelier than another, so that
/// a few assemblies determine their spread as Student's t does; smaller ones count as none; larger
/// ones are ever less likely, so that it is proper however few assemblies there are, as half-t
/// distributions are [Gelman, Bayesian Anal. 1 (2006) 515].
struct SpreadPrior {
  static constexpr double kNone = 0.005;  ///< s₀
  static constexpr double kUsual = 0.5;   ///< S
  static constexpr double kLeast = 1e-4;  ///< of σ as drawn: no spread at all
  static constexpr double kMost = 10.0;   ///< of σ as drawn

  /// ln p(ln σ), up to a constant; −∞ outside of the two ends.
  /// @param log_spread  ln σ.
  [[nodiscard]] static double log_density(double log_spread);

  /// A draw of σ given known deviations d ~ N(0, σ²).
  /// @param count   number of independent deviations.
  /// @param square  Σd².
  /// @param random  gives two numbers.
  [[nodiscard]] static double draw(double count, double square, RandomStream& random);
};

}  // namespace microslip
