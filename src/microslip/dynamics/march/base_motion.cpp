// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/base_motion.hpp"

#include <utility>

namespace microslip {

BaseMotion::BaseMotion(const JointedStructure& structure, const LoadHistory& loads,
                       const std::vector<std::string>& points)
    : time_(loads.time) {
  const ModalModel& linear = structure.linear();
  for (const PointForce& at : loads.forces) {
    if (!linear.is_base(at.point)) continue;
    Base moved{.acceleration = &at.force, .carried = {}};
    for (const std::string& point : points) {
      moved.carried.push_back(linear.carried(point, at.point));
    }
    moved.now = {0.0, 0.0, at.force.front()};
    bases_.push_back(std::move(moved));
  }
}

void BaseMotion::advance_to(double time) {
  while (interval_ + 2 < time_.size() && time >= time_[interval_ + 1]) {
    const double length = time_[interval_ + 1] - time_[interval_];
    for (Base& base : bases_) {
      const auto end = within(base, length);
      base.x = end[0];
      base.v = end[1];
    }
    ++interval_;
  }
  for (Base& base : bases_) base.now = within(base, time - time_[interval_]);
}

std::array<double, 3> BaseMotion::within(const Base& base, double elapsed) const {
  const double a = (*base.acceleration)[interval_];
  const double length = time_[interval_ + 1] - time_[interval_];
  const double slope = ((*base.acceleration)[interval_ + 1] - a) / length;
  const double v = base.v + elapsed * (a + 0.5 * elapsed * slope);
  const double x = base.x + elapsed * (base.v + elapsed * (a / 2.0 + elapsed * slope / 6.0));
  return {x, v, a + elapsed * slope};
}

std::array<double, 3> BaseMotion::of(std::size_t point) const {
  std::array<double, 3> sum = {};
  for (const Base& base : bases_) {
    for (std::size_t d = 0; d < sum.size(); ++d) sum[d] += base.carried[point] * base.now[d];
  }
  return sum;
}

}  // namespace microslip
