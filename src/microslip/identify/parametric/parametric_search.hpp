// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/parametric/parametric_form.hpp"

/// @file
/// Least squares over coordinates with bounds that may be hit. Internal: not installed.

namespace microslip {

struct LeastSquares {
  std::vector<Coordinate> coordinates;
  /// The residuals at q, of a length that does not change.
  std::function<Eigen::VectorXd(std::span<const double>)> residuals;
  /// Sums of squares below this are rounding: all are equally good.
  double rounding = 0.0;
};

/// Whether a coordinate moves or is fixed at a bound.
enum class Hold { kFree, kLower, kUpper };

struct Minimum {
  std::vector<double> q;
  std::vector<Hold> hold;
  double sum_of_squares = 0.0;
  bool converged = false;
  int iterations = 0;  ///< of all starts
  int starts = 0;
  int agreeing = 0;  ///< starts that ended within 1e-6 of the smallest sum

  [[nodiscard]] std::vector<std::size_t> free() const;
};

/// The smallest sum of squares over all combinations of coordinates fixed at admissible bounds.
/// @param candidates  q inside of the ranges, at least one; the best `starts` of them are followed.
[[nodiscard]] Minimum minimise(const LeastSquares& problem,
                               const std::vector<std::vector<double>>& candidates, int starts,
                               int max_evaluations);

/// ∂residuals/∂u over the free coordinates, by central differences.
[[nodiscard]] Eigen::MatrixXd free_jacobian(const LeastSquares& problem, const Minimum& minimum);

/// ∂f/∂u over the free coordinates of any vector f(q), by central differences.
[[nodiscard]] Eigen::MatrixXd free_jacobian(
    const LeastSquares& problem, const Minimum& minimum,
    const std::function<Eigen::VectorXd(std::span<const double>)>& f);

}  // namespace microslip
