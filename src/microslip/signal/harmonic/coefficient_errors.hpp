// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/algebra/core.hpp"
#include "microslip/signal/harmonic/fourier_fit_options.hpp"
#include "microslip/signal/harmonic/harmonic_regression.hpp"

namespace microslip {

/// Standard errors of a fit. Internal to signal.
struct CoefficientErrors {
  double big_omega = 0.0;        ///< of Ω
  Eigen::MatrixXd coefficients;  ///< unknowns × signals; that of Ω included
};

/// From the residuals. With r those of signal j, weight w_j = 1/σ_j², and sums over the record or a
/// block b of it,
///
///     δΩ = Σ_j w_j (r·x′ − Aᵀr·g) / Σ_j w_j curvature_j,   g = (AᵀA)⁻¹Aᵀx′
///     δa_j = (AᵀA)⁻¹Aᵀr − g δΩ
///
/// is what the noise adds to Ω and a, to first order. kWhite takes its expectation; kBlocks the sum
/// over the blocks of its square, times B/(B − 1) and points/(points − unknowns).
/// @param fix_omega  Ω was given: δΩ = 0.
[[nodiscard]] CoefficientErrors coefficient_errors(const HarmonicRegression& regression,
                                                   const HarmonicFit& fit,
                                                   const Eigen::MatrixXd& residuals,
                                                   ResidualModel model, bool fix_omega);

}  // namespace microslip
