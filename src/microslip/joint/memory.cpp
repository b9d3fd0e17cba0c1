// SPDX-License-Identifier: MIT
#include "microslip/joint/memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "microslip/joint/path.hpp"

namespace microslip {
Memory::Curve Memory::curve(const Branch& branch) const {
  const double sign = branch.direction < 0 ? -1.0 : 1.0;
  if (!branch.from_present && branch.depth == 0) {
    return {0.0, 0.0, sign, sign, 1.0, std::numeric_limits<double>::infinity()};
  }
  // A branch ends where the one before it turned, the first one at the mirror image of its own
  // start, where the virgin curve takes over.
  const std::size_t older = branch.from_present ? branch.depth : branch.depth - 1;
  const ReversalPoint origin =
      branch.from_present ? ReversalPoint{x_, force_} : reversals_[branch.depth - 1];
  const double end = older == 0 ? -origin.displacement : reversals_[older - 1].displacement;
  return {origin.displacement, origin.force, sign, 2.0 * sign, 0.5, sign * end};
}

/// The branch on which a step to x begins.
Memory::Branch Memory::first_branch(double x) const {
  if (!can_be_followed(x)) refuse_displacement("displacement", x);
  Branch branch{reversals_.size(), false, direction_};
  if (x != x_) {
    const int direction = x > x_ ? 1 : -1;
    branch.from_present = direction_ != 0 && direction != direction_;
    branch.direction = direction;
  }
  return branch;
}

/// Continues on the branch of which this one was a minor loop.
void Memory::close_loop(Branch& branch) {
  const std::size_t older = branch.from_present ? branch.depth : branch.depth - 1;
  branch.from_present = false;
  branch.depth = older == 0 ? 0 : older - 1;
}

Memory::Step Memory::step_to(double x) const {
  Branch branch = first_branch(x);
  for (;;) {  // close the minor loops that the step passes
    const Curve on = curve(branch);
    if (on.sign * x < on.end) return {branch, on};
    close_loop(branch);
  }
}

Memory::Curve Memory::curve_ahead(int direction, double x) const {
  Branch branch{reversals_.size(), direction_ != 0 && direction != direction_, direction};
  const double at = std::max(direction * x_, direction * x);
  for (;;) {
    const Curve on = curve(branch);
    if (at < on.end) return on;
    close_loop(branch);
  }
}

double Memory::dissipation(double x) const {
  const SlipDensity& density = joint_->density();
  Branch branch = first_branch(x);
  double sum = 0.0;
  for (double from = x_;;) {
    const Curve on = curve(branch);
    const bool ends_here = on.sign * x < on.end;
    const double to = ends_here ? x : on.sign * on.end;
    const double k = joint_->stiffness() * on.reach;
    sum += (density.slip_energy(k * std::abs(to - on.displacement)) -
            density.slip_energy(k * std::abs(from - on.displacement))) /
           k;  // dE/ds = Φ1
    if (ends_here) return sum;
    from = to;
    close_loop(branch);
  }
}

double Memory::stored_energy() const {
  const SlipDensity& density = joint_->density();
  const double k = joint_->stiffness();
  PartialMoments within;  // of the elements that are accounted for
  double sum = 0.0;
  // Those up to slip force s that are not yet, stretched by `offset` + sign·f*/k.
  const auto add = [&](double s, double offset, double sign) {
    const PartialMoments all = density.moments(s);
    sum += offset * (offset * (all.zeroth - within.zeroth) +
                     2.0 * sign / k * (all.first - within.first)) +
           (all.second - within.second) / (k * k);
    within = all;
  };
  double offset = 0.0;
  double sign = 0.0;  // of e where it slips now; no matter without an offset
  double x = x_;
  for (std::size_t i = reversals_.size(); i-- > 0;) {
    const double turned_at = reversals_[i].displacement;
    add(0.5 * k * std::abs(x - turned_at), offset, sign);
    offset = x_ - turned_at;
    sign = x > turned_at ? -1.0 : 1.0;  // it came from the other side
    x = turned_at;
  }
  add(k * std::abs(x), offset, sign);
  sum += (1.0 - within.zeroth) * x_ * x_;  // never slipped
  return 0.5 * k * sum;
}

double Memory::force_on(const Curve& on, double x) const {
  const double s = joint_->stiffness() * on.reach * std::abs(x - on.displacement);
  return on.force + on.scale * joint_->virgin_curve().force(s);
}

Memory::Response Memory::trial(double x) const {
  const Curve on = step_to(x).curve;
  return {force_on(on, x), joint_->tangent_stiffness(on.reach * std::abs(x - on.displacement))};
}

/// Updates all of the state but the force.
Memory::Curve Memory::move_to(double x) {
  const Step step = step_to(x);
  if (step.branch.from_present) {
    reversals_.push_back({x_, force_});
  } else {
    reversals_.resize(step.branch.depth);
  }
  x_ = x;
  direction_ = step.branch.direction;
  end_ = direction_ == 0 ? 0.0 : std::min(step.curve.end, kFarthestDisplacement);
  return step.curve;
}

double Memory::advance(double x) {
  force_ = force_on(move_to(x), x);
  return force_;
}

/// How many samples ahead neither turn nor close a loop.
std::size_t Memory::run_length(const Curve& on, std::span<const double> x) const {
  double reached = on.sign * x_;
  std::size_t i = 0;
  for (; i < x.size(); ++i) {
    const double ahead = on.sign * x[i];
    if (!(ahead >= reached && ahead < on.end)) break;
    reached = ahead;
  }
  return i;
}

// Most samples neither turn nor close a loop: they need no rules, only the virgin curve, in a loop
// without branches of which the processor overlaps several rounds.
void Memory::march(std::span<const double> x, std::span<double> force) {
  check_path(x, force);
  const VirginCurve& curve = joint_->virgin_curve();
  while (!x.empty()) {
    const Curve on = move_to(x.front());
    force_ = force_on(on, x_);
    force.front() = force_;
    x = x.subspan(1);
    force = force.subspan(1);
    const std::size_t run = direction_ == 0 ? 0 : run_length(on, x);
    if (run == 0) continue;
    x_ = x[run - 1];
    curve.branch_forces({on.displacement, on.force, joint_->stiffness() * on.reach, on.scale},
                        x.first(run), force.first(run));
    force_ = force[run - 1];
    x = x.subspan(run);
    force = force.subspan(run);
  }
}

void Memory::reset() {
  reversals_.clear();
  x_ = 0.0;
  force_ = 0.0;
  direction_ = 0;
  end_ = 0.0;
}

}  // namespace microslip
