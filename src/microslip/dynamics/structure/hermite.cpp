// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/hermite.hpp"

#include <cstddef>

namespace microslip {

Eigen::VectorXd hermite_value(std::span<const HermiteKnot> knots, double t) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(knots.front().value.size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    double lagrange = 1.0;
    double slope = 0.0;  // of it, at its knot
    for (std::size_t j = 0; j < knots.size(); ++j) {
      if (j == i) continue;
      const double apart = knots[i].t - knots[j].t;
      lagrange *= (t - knots[j].t) / apart;
      slope += 1.0 / apart;
    }
    const double away = t - knots[i].t;
    const double square = lagrange * lagrange;
    sum += square * (1.0 - 2.0 * slope * away) * knots[i].value + square * away * knots[i].slope;
  }
  return sum;
}

}  // namespace microslip
