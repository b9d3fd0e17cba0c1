// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace microslip {

/// How much a sensor moves in a mode whose shape changes with its frequency, as joints slip: its
/// displacement is φ(ω)q, q the modal amplitude. Empty where the shape does not change. Between the
/// frequencies all is linear in ln ω, beyond them as at the nearest.
struct ShapeCourse {
  std::vector<double> log_omega = {};   ///< ln of ω in rad/s, rising
  std::vector<double> log_motion = {};  ///< ln φ less that at the highest frequency
  std::vector<double> slope = {};       ///< d ln φ/d ln ω, 1
  std::vector<double> slope_std = {};   ///< its standard deviation, 1

  /// Whether the shape does not change.
  [[nodiscard]] bool empty() const { return log_omega.empty(); }

  /// ln φ less that at the highest frequency; 0 of an empty course. @param omega  rad/s.
  [[nodiscard]] double log_motion_at(double omega) const;
  /// d ln φ/d ln ω; 0 of an empty course. @param omega  rad/s.
  [[nodiscard]] double slope_at(double omega) const;
  /// Its standard deviation; 0 of an empty course. @param omega  rad/s.
  [[nodiscard]] double slope_std_at(double omega) const;
};

}  // namespace microslip
