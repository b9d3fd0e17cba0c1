// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/release.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr double kStandsStill = 1e-9;  // of what the shape could move the point by

}  // namespace

InitialState released(const JointedStructure& structure, std::string_view point,
                      std::span<const DrawnMode> modes) {
  const std::span<const double> shape = structure.linear().shape(point);
  const double most = std::sqrt(std::inner_product(shape.begin(), shape.end(), shape.begin(), 0.0));
  InitialState start{.displacement = std::vector<double>(shape.size(), 0.0)};
  std::set<std::size_t> drawn;
  for (const DrawnMode& one : modes) {
    const std::string name = fmt::format("mode {}", one.mode + 1);
    const std::vector<double> q = structure.stuck_mode(one.mode);
    if (!drawn.insert(one.mode).second) throw InputError(name, "twice", "must be given once");
    if (!(std::isfinite(one.displacement) && one.displacement != 0.0)) {
      throw InputError(fmt::format("displacement of {}", name), one.displacement,
                       "must be finite, and not 0");
    }
    const double moved = std::inner_product(shape.begin(), shape.end(), q.begin(), 0.0);
    if (std::abs(moved) <= kStandsStill * most) {
      throw InputError(name, fmt::format("no motion at '{}'", point), "must move the point",
                       "Take a point that is not a node of the mode.");
    }
    for (std::size_t i = 0; i < q.size(); ++i) {
      start.displacement[i] += one.displacement / moved * q[i];
    }
  }
  return start;
}

}  // namespace microslip
