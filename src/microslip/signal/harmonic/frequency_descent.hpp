// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/algebra/core.hpp"
#include "microslip/signal/harmonic/harmonic_regression.hpp"

namespace microslip {

/// Where Ω may lie. Internal to signal.
struct OmegaRange {
  double lowest;
  double highest;
};

/// A minimum over Ω. Internal to signal.
struct Descent {
  HarmonicFit fit;
  int iterations = 0;
  bool converged = false;
  double step = 0.0;  ///< the last, of Ω
};

/// ½ Σ_j ln(RSS_j/Σ y²): less the likelihood's logarithm, per point and but for a constant.
[[nodiscard]] double loss(const HarmonicRegression& regression, const HarmonicFit& fit);

/// 1/variance of Ω: Σ_j curvature_j/σ_j², σ_j² = RSS_j/(points − unknowns).
[[nodiscard]] double information(const HarmonicRegression& regression, const HarmonicFit& fit);

/// Gauss–Newton steps on Ω that lower the loss, halved until they do. Converged: the next step is
/// below 1e−4 standard errors of Ω, 1e−13 of Ω or what rounding of the gradient makes of it.
[[nodiscard]] Descent descend(const HarmonicRegression& regression, double big_omega,
                              Eigen::Index order, OmegaRange range, int max_iterations);

}  // namespace microslip
