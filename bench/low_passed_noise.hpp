// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/march/march.hpp"

namespace microslip::bench {

/// White noise through two low passes of 100 Hz, 20 N rms or so at "tip".
/// @param seconds  its length. @param rate  values a second.
inline LoadHistory low_passed_noise(double seconds, double rate) {
  const double keep = std::exp(-2.0 * std::numbers::pi * 100.0 / rate);
  const double size = 100.0 * std::sqrt(rate / 4096.0);
  LoadHistory loads{{}, {{"tip", {}}}};
  RandomStream random(3, 0);
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; static_cast<double>(i) <= seconds * rate; ++i) {
    loads.time.push_back(static_cast<double>(i) / rate);
    loads.forces[0].force.push_back(size * second);
    first += (1.0 - keep) * (random.normal() - first);
    second += (1.0 - keep) * (first - second);
  }
  return loads;
}

}  // namespace microslip::bench
