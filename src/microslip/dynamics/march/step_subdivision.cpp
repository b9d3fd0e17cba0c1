// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "microslip/dynamics/march/march_state.hpp"
#include "microslip/dynamics/structure/bracketed_newton.hpp"

/// @file
/// The steps of a MarchState in pieces that end where a joint turns or its tangent jumps.

namespace microslip {
namespace {

/// Turns nearer to an end of a step than this share of it are at that end.
constexpr double kNear = 1e-9;
constexpr double kStepRounding = 1e-12;
/// Shares of a step are found to this.
constexpr double kShareRounding = 1e-12;
/// Turns and kinks in one step; where there are more the joint is at rest up to rounding.
constexpr int kMostChanges = 100;
/// Pieces of a step that are shorter than this share of it are not tried.
constexpr double kLeastPiece = 1e-6;

int sign_of(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

/// Next to an end of the step, that end.
double rounded_share(double share) {
  if (share > 1.0 - kNear) return 1.0;
  return share > kNear ? share : 0.0;
}

}  // namespace

// ---- Steps and their cuts. ----

/// Steps as a whole, or else in pieces that end where a joint turns or its tangent jumps. Where the
/// equations of a piece do not converge, a shorter one is tried.
bool MarchState::step(const StepWeights& weights) {
  if (step_over_breakpoints(weights)) return true;
  double left = weights.length();
  double piece = left;
  int changes = 0;
  for (;;) {
    extrapolate(piece);
    if (!solve_piece(piece, weights)) {
      if (piece <= kLeastPiece * weights.length()) return false;
      piece *= 0.5;
      continue;
    }
    const Change next = changes < kMostChanges ? first_change(piece) : Change{};
    if (next.share <= 0.0) {
      change(next);
      ++changes;
      continue;
    }
    if (next.share < 1.0) {
      interpolate(next.share, piece);
      piece *= next.share;
      if (!solve_piece(piece, weights)) continue;
      accept(piece, Quadrature::kEnds);
      change(next);
      ++changes;
    } else {
      accept(piece, Quadrature::kEnds);
    }
    pass_kinks();
    left -= piece;
    if (left <= kStepRounding * weights.length()) return true;
    piece = left;
  }
}

/// @return false where nothing was done.
bool MarchState::step_over_breakpoints(const StepWeights& weights) {
  if (weights.length() > longest_over_breakpoints_) return false;
  extrapolate(weights.length());
  if (!solve(weights, couplings_, Breakpoints::kAllowed)) return false;
  accept(weights.length(), Quadrature::kInner);
  pass_kinks();
  return true;
}

bool MarchState::solve_piece(double length, const StepWeights& whole) {
  if (length == whole.length()) return solve(whole, couplings_, Breakpoints::kNone);
  cut_.set_length(length);
  return solve(cut_, cut_couplings_, Breakpoints::kNone);
}

/// The integrals of the differences from the cubics by the breakpoints of all joints up to the
/// inner points.
void MarchState::look_inside(double length) {
  if (any_breakpoints_inside_) std::ranges::fill(breakpoints_inside_, 0.0);
  any_breakpoints_inside_ = false;
  for (const Joint& joint : joints_) {
    if (joint.path.breakpoints().empty()) continue;
    any_breakpoints_inside_ = true;
    std::array<double, kInnerPoints> integrals;
    integrate_breakpoints(joint.path.breakpoints(), force_cubic(joint, length), kInnerPoint,
                          integrals.data());
    for (std::size_t point = 0; point < kInnerPoints; ++point) {
      const double integral = integrals[point];
      double* to = breakpoints_inside_.data() + point * q_.size();
      for (std::size_t i = 0; i < q_.size(); ++i) to[i] -= integral * joint.shape[i];
    }
  }
}

/// Over a step that was solved. Inner points of a piece of a step would take weights of its own.
void MarchState::add_energies(double length, Quadrature quadrature) {
  const march_loops::State from{q_.data(), v_.data(), load_.data(), load_slope_.data(),
                                loads_.force.data()};
  const march_loops::State to{end_q_.data(), end_v_.data(), end_load_.data(),
                              end_load_slope_.data(), end_force_.data()};
  march_loops::Energies added{};
  if (quadrature == Quadrature::kInner) {
    quadrature_.set_length(length);
    look_inside(length);
    added = march_loops::inner_energies(groups_, length, quadrature_.data(), damping_.data(), from,
                                        to, loads_.slope.data(), end_load_middle_.data(),
                                        breakpoints_inside_.data());
  } else {
    added = march_loops::step_energies(groups_, length, stiffness_.data(), damping_.data(), from,
                                       to, loads_.slope.data());
  }
  input_ += added.input;
  loss_ += added.loss;
}

void MarchState::accept(double length, Quadrature quadrature) {
  for (std::size_t i = 0; i < end_force_.size(); ++i) {
    end_force_[i] = loads_.force[i] + length * loads_.slope[i];
  }
  add_energies(length, quadrature);
  std::swap(q_, end_q_);
  std::swap(v_, end_v_);
  std::swap(load_, end_load_);
  std::swap(load_slope_, end_load_slope_);
  std::swap(loads_.force, end_force_);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    Kinematics& k = joint.end;
    loads_.normal[j] = normal_load(j, length);
    pass_breakpoints(joint);
    const double damped = joint.damper * k.u_dot;
    k.force = damped + joint.hysteresis.settle(k.gap - joint.compliance * k.force, loads_.normal[j],
                                               k.force - damped);
    const Kinematics& b = joint.begin;
    joint.damped += joint.damper * length *
                    (0.5 * (b.u_dot * b.u_dot + k.u_dot * k.u_dot) +
                     length / 6.0 * (b.u_dot * b.u_ddot - k.u_dot * k.u_ddot));
    joint.curvature = curvature(joint, length);
    joint.begin = k;
    joint.turned_here = false;
    joint.largest_force = std::max(joint.largest_force, std::abs(k.force));
    joint.largest_gap = std::max(joint.largest_gap, std::abs(k.gap));
    if (joint.direction == 0) set_off(joint);
  }
  begin_accelerations();
  ++steps_;
}

/// The curvature over the step, or its part behind the last breakpoint.
MarchState::Curvature MarchState::curvature(const Joint& joint, double length) {
  const Kinematics& b = joint.begin;
  const Kinematics& k = joint.end;
  if (joint.path.breakpoints().empty()) {
    return {(k.force_dot - b.force_dot) / length, (k.r_dot - b.r_dot) / length};
  }
  const JointPath::Breakpoint& last = joint.path.breakpoints().back();
  const double left = length * std::max(1.0 - last.share, kLeastPiece);
  const double force = (k.force_dot - last.after / length) / left;
  return {force, force - joint.spring * (k.slide_dot - b.slide_dot) / length};
}

/// Passes the breakpoints on the path of a joint over the step.
void MarchState::pass_breakpoints(Joint& joint) {
  if (joint.path.breakpoints().empty()) return;
  for (const JointPath::Breakpoint& breakpoint : joint.path.breakpoints()) {
    if (breakpoint.turns) {
      joint.hysteresis.turned(breakpoint.displacement, breakpoint.force);
      joint.direction = -joint.direction;
      ++reversals_;
    } else {
      ++kinks_;
    }
  }
  joint.hysteresis.take_over(joint.path.follower());
  find_kink(joint);
}

void MarchState::set_off(Joint& joint) {
  joint.direction = sign_of(joint.begin.gap_dot);
  if (joint.direction == 0) return;
  joint.hysteresis.turn(joint.direction);
  find_kink(joint);
}

// ---- Where joints turn, and where their tangents jump. ----

void MarchState::change(const Change& change) {
  contraction_ = 1.0;  // on another curve
  Joint& joint = joints_[change.joint];
  if (change.turns) {
    turn(joint);
    joint.turned_here = change.share <= 0.0;
  } else {
    pass_kink(joint);
  }
}

void MarchState::turn(Joint& joint) {
  joint.direction = -joint.direction;
  joint.hysteresis.turn(joint.direction);
  find_kink(joint);
  ++reversals_;
}

/// The tangent jumps here, and with it the slopes of the loads.
void MarchState::pass_kink(Joint& joint) {
  const auto stiffness = [&] { return in_series(joint.hysteresis.tangent(), joint.compliance); };
  const double before = stiffness();
  joint.hysteresis.pass_kink();
  find_kink(joint);
  ++kinks_;
  Kinematics& k = joint.begin;
  const double jump = (stiffness() - before) * k.gap_dot;
  k.force_dot += jump;
  k.r_dot += jump;
  for (std::size_t i = 0; i < load_slope_.size(); ++i) load_slope_[i] -= jump * joint.shape[i];
  if (joint.gamma.empty()) return;
  march_loops::shorten(groups_, joint.gamma.data(), q_.data(), v_.data(), joint.g.data(),
                       joint.g_dot.data());
  for (std::size_t i = 0; i < load_slope_.size(); ++i) load_slope_[i] += jump * joint.g[i];
}

/// The kinks that the joints have come to.
void MarchState::pass_kinks() {
  for (Joint& joint : joints_) {
    for (int i = 0; i < kMostChanges && joint.direction * (joint.kink - joint.begin.gap) < 0.0;
         ++i) {
      pass_kink(joint);
    }
  }
}

void MarchState::find_kink(Joint& joint) {
  joint.kink = joint.hysteresis.is_network()
                   ? joint.direction * HUGE_VAL
                   : joint.hysteresis.follower().next_kink_behind(joint.compliance);
}

MarchState::Change MarchState::first_change(double length) {
  Change first;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    const StepCubic y(joint.begin.gap, joint.begin.gap_dot, joint.end.gap, joint.end.gap_dot,
                      length);
    // It turns once at one place: a joint that turns back at once is at rest up to rounding.
    const double turn = joint.turned_here ? 1.0 : turning_share(joint, y, length);
    if (turn < first.share) first = {turn, j, true};
    const double kink = kink_share(joint, y, std::min(turn, 1.0));
    if (kink < first.share) first = {kink, j, false};
  }
  return first;
}

/// The share of the step at which a joint turns, by the cubic through y and ẏ at its ends: ẏ there
/// is of the order h³ and y off its extreme by h⁶. 1 where it does not, 0 where it has turned
/// already.
double MarchState::turning_share(const Joint& joint, const StepCubic& y, double length) {
  const auto ahead = [&](double share) { return joint.direction * y.slope(share); };
  if (length * std::max(std::abs(joint.begin.gap_dot), std::abs(joint.end.gap_dot)) <=
      kQuiet * joint.largest_gap) {
    return ahead(1.0) < 0.0 ? 0.0 : 1.0;
  }
  // The slope is a parabola: it may dip below 0 and come back within the step, or rise above and
  // fall.
  const double vertex = y.c == 0.0 ? -1.0 : -y.b / (3.0 * y.c);
  const bool bends = vertex > 0.0 && vertex < 1.0;
  double low = 0.0;
  double high = 1.0;
  if (bends && ahead(vertex) > 0.0) low = vertex;
  if (ahead(low) <= 0.0) return ahead(0.5) >= 0.0 ? 1.0 : 0.0;
  if (bends && ahead(vertex) < 0.0) high = vertex;
  if (ahead(high) >= 0.0) return 1.0;
  return rounded_share(growing_zero(
      [&](double share) {
        return Growing{-ahead(share), -joint.direction * y.bend(share)};
      },
      low, high, kShareRounding));
}

/// The share at which y reaches the next kink, before `until`, up to which it does not turn.
double MarchState::kink_share(const Joint& joint, const StepCubic& y, double until) {
  // The compliance in series also deforms under the damper.
  const double kink = joint.kink + joint.compliance * joint.damper * joint.begin.u_dot;
  const auto ahead = [&](double share) { return joint.direction * (kink - y.value(share)); };
  if (joint.direction == 0 || !(ahead(until) < 0.0)) return 1.0;
  return rounded_share(growing_zero(
      [&](double share) {
        return Growing{-ahead(share), joint.direction * y.slope(share)};
      },
      0.0, until, kShareRounding));
}

}  // namespace microslip
