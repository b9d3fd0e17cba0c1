// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/sampled_curves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "microslip/joint/memory.hpp"

namespace microslip {

std::vector<double> equal_ratios(double from, double to, std::size_t count) {
  constexpr double kOne = 1.01;
  if (to < kOne * from) {
    from /= std::numbers::sqrt2;
    to *= std::numbers::sqrt2;
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    values.push_back(from * std::pow(to / from, share));
  }
  return values;
}

DensityPoints density_points(const Joint& joint, double from, double to) {
  constexpr std::size_t kPoints = 240;
  constexpr double kBelow = 1.0 - 1e-9;
  DensityPoints points;
  for (std::size_t i = 0; i <= kPoints; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kPoints);
    const double f = from + (to - from) * share;
    const double density = joint.density().density(std::min(f, kBelow * to));
    if (!std::isfinite(density)) continue;
    points.slip_force.push_back(f);
    points.density.push_back(density);
  }
  return points;
}

Curve slipped_share(const Joint& joint, double to) {
  constexpr std::size_t kPoints = 2000;
  Curve curve;
  for (std::size_t i = 0; i <= kPoints; ++i) {
    curve.x.push_back(to * static_cast<double>(i) / static_cast<double>(kPoints));
    curve.y.push_back(joint.density().moments(curve.x.back()).zeroth);
  }
  return curve;
}

SteadyLoop steady_loop(const Joint& joint, double amplitude, std::size_t half) {
  SteadyLoop loop;
  Memory memory(joint);
  memory.advance(amplitude);
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < half; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(half);
      loop.displacement.push_back(sign * amplitude * (1.0 - 2.0 * share));
      loop.force.push_back(memory.advance(loop.displacement.back()));
    }
  }
  return loop;
}

std::vector<double> joint_curve(const Joint& joint, JointQuantity quantity,
                                const std::vector<double>& amplitude, double linear_damping) {
  std::vector<double> values;
  for (const double a : amplitude) values.push_back(quantity(joint, a) + linear_damping * a * a);
  return values;
}

std::vector<double> force_difference(const SteadyLoop& loop, const SteadyLoop& base) {
  std::vector<double> apart(loop.force.size());
  std::ranges::transform(loop.force, base.force, apart.begin(), std::minus());
  return apart;
}

std::vector<double> loop_amplitudes(double largest) {
  return {largest, 0.75 * largest, 0.5 * largest, 0.25 * largest};
}

}  // namespace microslip
