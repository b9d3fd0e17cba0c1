// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/calibrate/calibration_result.hpp"

/// @file
/// Frequency offsets of the modes of a structure as unknowns. Internal to calibrate.

namespace microslip {

/// Offsets ε_i of ln ω_i of the modes without joints, normally distributed before the levels,
///
///     ε_i ~ N(m, s²),   x_i = 20 + (ε_i − m)/s ≥ 0
///
/// with the coefficients x_i beside those of the joints, and fixed offsets μ_j of half of ln k_s,j
/// of the springs that the modes have across the joints. First the modes, then the joints.
struct ModeUnknowns {
  double mean = 0.0;              ///< m, 1
  std::vector<double> unit = {};  ///< s, 1; 0 of what is fixed; none: all is exact
  /// Whether the levels of a vibration determine its offset: what is common to their frequencies
  /// then counts with it, and else nothing but their change.
  std::vector<bool> determined = {};
  std::vector<double> start = {};  ///< offsets to begin with, and fixed ones, 1

  /// No frequency is so far off that the limit x ≥ 0 counts.
  static constexpr double kInside = 20.0;

  [[nodiscard]] std::size_t count() const { return unit.size(); }

  /// The same with modes as given, to kFrequencyResolution.
  [[nodiscard]] ModeUnknowns as_given() const {
    ModeUnknowns exact = *this;
    exact.mean = 0.0;
    for (double& each : exact.unit) each = each > 0.0 ? kFrequencyResolution : 0.0;
    exact.start.assign(count(), 0.0);
    return exact;
  }

  /// Offsets of coefficients, and coefficients of offsets.
  [[nodiscard]] std::vector<double> offsets(const Eigen::VectorXd& x) const {
    std::vector<double> all(count());
    for (std::size_t i = 0; i < count(); ++i) {
      const double own = unit[i] * (x(static_cast<Eigen::Index>(i)) - kInside);
      all[i] = unit[i] > 0.0 ? mean + own : start[i];
    }
    return all;
  }
  [[nodiscard]] Eigen::VectorXd coefficients(const std::vector<double>& offsets) const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(count()));
    for (std::size_t i = 0; i < count(); ++i) {
      const double own = unit[i] > 0.0 ? (offsets[i] - mean) / unit[i] : 0.0;
      x(static_cast<Eigen::Index>(i)) = kInside + own;
    }
    return x;
  }
};

}  // namespace microslip
