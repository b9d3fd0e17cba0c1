// SPDX-License-Identifier: MIT
#include "band_limited_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/base/random.hpp"

namespace microslip::bench {

std::vector<double> band_limited_path(std::size_t samples, double largest) {
  RandomStream random(2014, 0);
  std::vector<double> x(samples, 0.0);
  constexpr int kTones = 64;
  for (int tone = 0; tone < kTones; ++tone) {
    const double amplitude = random.normal();
    const double phase = 2.0 * std::numbers::pi * random.uniform();
    const double cycles_per_sample = (20.0 + 80.0 * random.uniform()) / 8192.0;
    for (std::size_t i = 0; i < samples; ++i) {
      const double angle = 2.0 * std::numbers::pi * cycles_per_sample * static_cast<double>(i);
      x[i] += amplitude * std::sin(angle + phase);
    }
  }
  double peak = 0.0;
  for (const double value : x) peak = std::max(peak, std::abs(value));
  for (double& value : x) value *= largest / peak;
  return x;
}

Joint joint_of_100_segments() {
  constexpr int kSegments = 100;
  constexpr double kWidth = 0.5;  // N
  constexpr double kWeight = 0.95;
  RandomStream random(2014, 1);
  PiecewiseLinearPart part;
  for (int i = 0; i <= kSegments; ++i) {
    part.slip_force.push_back(kWidth * i);
    part.density.push_back(0.5 + random.uniform());
  }
  double area = 0.0;
  for (std::size_t i = 1; i < part.density.size(); ++i) {
    area += 0.5 * kWidth * (part.density[i - 1] + part.density[i]);
  }
  for (double& ordinate : part.density) ordinate *= kWeight / area;
  std::vector<DensityPart> parts;
  parts.emplace_back(std::move(part));
  return Joint(1.7e5, SlipDensity(std::move(parts)));
}

}  // namespace microslip::bench
