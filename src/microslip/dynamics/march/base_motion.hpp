// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "microslip/dynamics/march/load_history.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// Motion of some points due to accelerating bases, over time: Σ_b r_p(b) x_b(t). The accelerations
/// are linear in time between the times of the loads, so that x_b, from rest at 0, is a cubic
/// there, in closed form. Internal to dynamics.
class BaseMotion {
 public:
  /// @param loads   kept by reference. @param points  names of points of the structure.
  BaseMotion(const JointedStructure& structure, const LoadHistory& loads,
             const std::vector<std::string>& points);

  /// Whether any base accelerates.
  [[nodiscard]] bool any() const { return !bases_.empty(); }

  /// To a time that is not earlier than the last one.
  void advance_to(double time);

  /// Present motion of a point: m, m/s, m/s².
  [[nodiscard]] std::array<double, 3> of(std::size_t point) const;

 private:
  struct Base {
    const std::vector<double>* acceleration;  // of the loads, one per time
    std::vector<double> carried;              // r of each point
    double x = 0.0;                           // at the begin of the interval
    double v = 0.0;
    std::array<double, 3> now = {};
  };

  /// The motion of a base `elapsed` after the begin of the interval.
  [[nodiscard]] std::array<double, 3> within(const Base& base, double elapsed) const;

  const std::vector<double>& time_;
  std::size_t interval_ = 0;
  std::vector<Base> bases_;
};

}  // namespace microslip
