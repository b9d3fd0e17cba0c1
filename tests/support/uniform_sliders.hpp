// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

/// @file A joint of 300 equal springs with limits that are evenly spread, moved one by one, and
/// what it does at an amplitude by closed forms. Nothing of joint/ is used.

namespace microslip::testing {

class UniformSliders {
 public:
  /// Stiffness of the first harmonic and loss per cycle.
  struct Secant {
    double stiffness = 0.0;
    double loss = 0.0;
  };

  /// @param stiffness  of all, N/m. @param longest  slip displacement of the last, m.
  UniformSliders(double stiffness, double longest) : each_(stiffness / kCount), longest_(longest) {}

  /// At an amplitude u, m: of each the loop of an elastic, ideally plastic element.
  [[nodiscard]] Secant secant(double u) const {
    Secant sum;
    for (int i = 0; i < kCount; ++i) {
      const double slip = slip_displacement(i);
      if (u <= slip) {
        sum.stiffness += each_;
        continue;
      }
      const double theta = std::acos(1.0 - 2.0 * slip / u);
      sum.stiffness += each_ / std::numbers::pi * (theta - 0.5 * std::sin(2.0 * theta));
      sum.loss += 4.0 * each_ * slip * (u - slip);
    }
    return sum;
  }

  /// Brings them to a displacement x, m, from where they are, at first at rest. @return  force, N.
  double force(double x) {
    double sum = 0.0;
    for (int i = 0; i < kCount; ++i) {
      double& slid = slid_[static_cast<std::size_t>(i)];
      const double slip = slip_displacement(i);
      slid = std::clamp(slid, x - slip, x + slip);
      sum += each_ * (x - slid);
    }
    return sum;
  }

 private:
  static constexpr int kCount = 300;

  [[nodiscard]] double slip_displacement(int i) const { return longest_ * (i + 0.5) / kCount; }

  double each_;
  double longest_;
  std::vector<double> slid_ = std::vector<double>(kCount);
};

}  // namespace microslip::testing
