// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/structure/modal_model.hpp"

/// @file
/// The functions of ω of which frequency responses with common poles are sums. Internal to modes.

namespace microslip {

/// ln of ω (in units of the middle of the band) and η.
struct ResponsePole {
  double log_frequency;
  double log_loss;

  [[nodiscard]] double frequency() const { return std::exp(log_frequency); }
  [[nodiscard]] double loss() const { return std::exp(log_loss); }
};

/// Responses over the same ω with the same p, weighed; complex values as their parts, one below the
/// other.
struct ResponseGroup {
  Eigen::VectorXd x;  // ω over the middle of the band
  int derivatives;
  std::vector<std::size_t> members;
  Eigen::MatrixXd values;  // 2N × members
};

/// Numerators that modes may have.
enum class Numerators { kReal, kComplex };

/// Least squares of a group: its coefficients, and what they leave.
struct LinearFit {
  Eigen::MatrixXd basis_directions;  // Q
  Eigen::MatrixXd coefficients;      // columns of the basis × members
  Eigen::MatrixXd rest;
  Eigen::MatrixXd inverse;  // (ΦᵀΦ)⁻¹
};

/// Complex values as their real parts, and their imaginary parts below these.
[[nodiscard]] Eigen::MatrixXd parts_of_complex(const Eigen::MatrixXcd& values);

/// The columns of modes, then those of L and U, see fit_responses().
[[nodiscard]] Eigen::MatrixXd response_basis(const ResponseGroup& group,
                                             std::span<const ResponsePole> poles, DampingLaw law,
                                             Numerators kind);

/// Derivatives of the two columns of each mode with complex numerators by ln ω, then by ln η: 4 per
/// mode. Parts parallel to a column of the basis are left out; they are projected away.
[[nodiscard]] Eigen::MatrixXd response_slopes(const ResponseGroup& group,
                                              std::span<const ResponsePole> poles, DampingLaw law);

/// The coefficients of a basis with which the values of a group differ least from it.
[[nodiscard]] LinearFit fit_linearly(const ResponseGroup& group, const Eigen::MatrixXd& basis);

}  // namespace microslip
