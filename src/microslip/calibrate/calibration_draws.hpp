// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/calibrate/growing_range.hpp"

/// @file
/// Draws of all exponents in common coefficients. Internal to calibrate.

namespace microslip {

/// Common coefficients of the draws, and the draws. Those of one exponent are spread evenly over
/// all.
struct CalibrationDraws {
  AllUnknowns unknowns;
  std::vector<Eigen::VectorXd> posterior = {};
  std::vector<Eigen::VectorXd> prior = {};  ///< without the levels

  /// Mean of the posterior.
  [[nodiscard]] Eigen::VectorXd mean() const;
};

/// Draws each state by its weight. Where there are several, the coefficients are ψ at the knots.
/// @param states  GrowingRange::with_others().
/// @param least   smallest τ of each kind of rows.
/// @param count   of draws of the posterior.
/// @param seed    of the draws.
[[nodiscard]] CalibrationDraws draw_all(const std::vector<WeighedState>& states,
                                        const std::array<double, kRowKinds.size()>& least,
                                        std::size_t count, std::uint64_t seed);

}  // namespace microslip
