// SPDX-License-Identifier: MIT
#include "microslip/observe/turning_samples.hpp"

#include <cmath>

namespace microslip {

std::vector<std::size_t> turning_samples(std::span<const double> path, double threshold) {
  std::vector<std::size_t> turns = {0};
  std::size_t extreme = 0;  // the furthest since the last turn
  double direction = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double beyond = path[i] - path[extreme];
    if (direction == 0.0) {
      if (std::abs(path[i] - path[0]) <= threshold) continue;
      direction = path[i] > path[0] ? 1.0 : -1.0;
      extreme = i;
    } else if (direction * beyond >= 0.0) {
      extreme = i;
    } else if (-direction * beyond > threshold) {
      turns.push_back(extreme);
      direction = -direction;
      extreme = i;
    }
  }
  if (turns.back() + 1 < path.size()) turns.push_back(path.size() - 1);
  return turns;
}

}  // namespace microslip
