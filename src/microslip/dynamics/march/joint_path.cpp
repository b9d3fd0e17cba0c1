// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/joint_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/dynamics/structure/bracketed_newton.hpp"

namespace microslip {
namespace {

/// Changes nearer to an end of the step than this share of it are at that end.
constexpr double kAtEnd = 1e-9;
/// Shares are found to about the square of this: the last step of Newton's method is below it.
constexpr double kWithin = 1e-7;

/// The share at which a motion with a slope of this sign at `from` turns, which has turned at `to`;
/// 1 next to an end of the step.
/// @param first  is tried first.
double extreme_between(const StepQuartic& y, double sign, double first, double from, double to) {
  const double share = growing_zero_near(
      [&](double x) {
        return Growing{-sign * y.slope(x), -sign * y.bend(x)};
      },
      first, from, to, kWithin);
  return share > kAtEnd && share < 1.0 - kAtEnd ? share : 1.0;
}

/// The shares of a step at which a quartic has its extremes, two at most, by rising share; 1 where
/// it has none.
/// @param near  where the first may be; 0 where that is not known.
std::pair<double, double> extremes(const StepQuartic& y, double near) {
  const double sign = std::copysign(1.0, y.v0 == 0.0 ? y.v1 : y.v0);
  if (sign * y.v1 < 0.0) {
    const double first = near > 0.0 ? near : y.v0 / (y.v0 - y.v1);
    return {extreme_between(y, sign, first, 0.0, 1.0), 1.0};
  }
  // It turns and turns back where its slope falls at first, below 0, and rises at last.
  if (!(sign * y.bend(0.0) < 0.0 && sign * y.bend(1.0) > 0.0)) return {1.0, 1.0};
  const double lowest = growing_zero(
      [&](double x) {
        return Growing{sign * y.bend(x), sign * y.bend_slope(x)};
      },
      0.0, 1.0, kWithin);
  if (sign * y.slope(lowest) >= 0.0) return {1.0, 1.0};
  return {extreme_between(y, sign, 0.5 * lowest, 0.0, lowest),
          extreme_between(y, -sign, 0.5 * (1.0 + lowest), lowest, 1.0)};
}

}  // namespace

bool JointPath::follow(const Start& start, const StepQuartic& y) {
  const double near = first_turn();
  before_ = std::exchange(size_, 0);
  if (start.direction == 0) return true;
  if (std::max(std::abs(y.v0), std::abs(y.v1)) <= start.quiet) return start.direction * y.v1 >= 0.0;
  const auto [first, second] = extremes(y, near);
  if (!(start.direction * y.slope(0.5 * first) > 0.0)) return false;
  direction_ = start.direction;
  compliance_ = start.compliance;
  if (first == 1.0 && direction_ * (start.kink - y.value(1.0)) >= 0.0) return true;
  follower_ = start.follower;
  double from = 0.0;
  for (const double share : {first, second}) {
    if (!pass_kinks(y, from, share)) return false;
    if (share == 1.0) return true;
    if (!turn(y, share, size_ == 0 ? start.force : breakpoints_[size_ - 1].force)) return false;
    from = share;
  }
  return pass_kinks(y, from, 1.0);
}

/// 0 where there is none.
double JointPath::first_turn() const {
  const auto turn = std::ranges::find(breakpoints(), true, &Breakpoint::turns);
  return turn == breakpoints().end() ? 0.0 : turn->share;
}

bool JointPath::add(const Breakpoint& breakpoint) {
  if (size_ == kMostBreakpoints) return false;
  breakpoints_[size_++] = breakpoint;
  return true;
}

/// Passes the kinks between two shares, where y does not turn.
bool JointPath::pass_kinks(const StepQuartic& y, double from, double to) {
  const double end = y.value(to);
  const auto stiffness = [&](double tangent) { return in_series(tangent, compliance_); };
  for (;;) {
    const double at = follower_.next_kink_behind(compliance_);
    if (direction_ * (at - end) >= 0.0) return true;
    const double begin = y.value(from);
    const double near = size_ < before_ ? breakpoints_[size_].share
                                        : from + (to - from) * (at - begin) / (end - begin);
    const double share = growing_zero_near(
        [&](double x) {
          return Growing{direction_ * (y.value(x) - at), direction_ * y.slope(x)};
        },
        near, from, to, kWithin);
    const double u = follower_.next_kink();
    const double slope = y.slope(share);
    const auto [force, before] = follower_.response(u);
    follower_.pass_kink();
    const double after = follower_.response(u).tangent;
    if (!add({share, u, force, stiffness(before) * slope, stiffness(after) * slope, false})) {
      return false;
    }
    from = share;
  }
}

/// @param force  near the one there.
bool JointPath::turn(const StepQuartic& y, double share, double force) {
  const double extreme = y.value(share);
  double u = extreme - compliance_ * force;
  for (int i = 0; i < 50 && compliance_ > 0.0; ++i) {  // u + cF(u) = y
    const auto [f, tangent] = follower_.response(u);
    const double miss = extreme - u - compliance_ * f;
    u += miss / (1.0 + compliance_ * tangent);
    if (std::abs(miss) <= 1e-14 * std::abs(extreme)) break;
  }
  direction_ = -direction_;
  const double there = follower_.response(u).force;
  follower_.settle(u, there);
  follower_.turn(direction_);
  return add({share, u, there, 0.0, 0.0, true});
}

}  // namespace microslip
