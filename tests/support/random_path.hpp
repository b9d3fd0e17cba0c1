// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/base/random.hpp"

namespace microslip::testing {

/// A path of `turns` reversals with up to `most_steps` samples between two of them. The turning
/// points are drawn with an amplitude that itself is drawn anew each time, mostly small, so that
/// loops nest deeply, close, and the largest |x| so far is passed again and again. Some samples
/// repeat.
inline std::vector<double> random_path(std::uint64_t seed, std::size_t turns, double amplitude,
                                       std::size_t most_steps = 1) {
  RandomStream random(seed, 0);
  std::vector<double> x;
  double from = 0.0;
  double direction = random.uniform() < 0.5 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < turns; ++i) {
    const double scale = random.uniform();
    double step = 2.0 * amplitude * scale * scale * scale * random.uniform();
    if (direction * from + step > amplitude) step = amplitude - direction * from;  // turn there
    const auto steps = std::max<std::size_t>(
        1, static_cast<std::size_t>(random.uniform() * static_cast<double>(most_steps) + 0.5));
    const double to = from + direction * step;
    for (std::size_t j = 1; j <= steps; ++j) {
      x.push_back(j == steps
                      ? to
                      : from + (to - from) * static_cast<double>(j) / static_cast<double>(steps));
      if (most_steps > 1 && random.uniform() < 0.1) x.push_back(x.back());
    }
    from = to;
    direction = -direction;
  }
  return x;
}

}  // namespace microslip::testing
