// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/signal/harmonic/fourier_fit_options.hpp"
#include "microslip/signal/harmonic/frequency_descent.hpp"
#include "microslip/signal/harmonic/harmonic_regression.hpp"

namespace microslip {

/// The fit at the fundamental that was found. Internal to signal.
struct Fundamental {
  HarmonicFit fit;      ///< not determined where nothing could be fitted
  std::string failure;  ///< why it is not to be used; empty where it is
  int iterations = 0;
  double step = 0.0;  ///< last of Ω, relative
  std::vector<Warning> warnings;
};

/// Least number of cycles in a record.
inline constexpr double kLeastCycles = 3.0;

/// Finds the fundamental by the rule of fourier_fit.hpp.
/// @param signals  the signals of the regression, of mean square 1.
[[nodiscard]] Fundamental find_fundamental(const HarmonicRegression& regression,
                                           const Eigen::MatrixXd& signals,
                                           const FourierFitOptions& options);

}  // namespace microslip
