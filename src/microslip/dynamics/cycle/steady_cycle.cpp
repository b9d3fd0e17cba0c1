// SPDX-License-Identifier: MIT
#include "microslip/dynamics/cycle/steady_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "microslip/dynamics/structure/bracketed_newton.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Whether x(τ + π) = −x(τ): no even harmonics.
bool is_odd_wave(std::span<const double> coefficients) {
  for (Index i = 0; i < static_cast<Index>(coefficients.size()); ++i) {
    if (is_even_coefficient(i) && coefficients[static_cast<std::size_t>(i)] != 0.0) return false;
  }
  return true;
}

std::span<const double> stretch_of(const VectorXd& x, Index first, Index count) {
  return {x.data() + first, static_cast<std::size_t>(count)};
}

std::span<double> stretch_of(VectorXd& x, Index first, Index count) {
  return {x.data() + first, static_cast<std::size_t>(count)};
}

}  // namespace

SteadyCycle::Columns::Columns(Wave which, std::size_t harmonics)
    : wave(which), motion(coefficients_of(which, harmonics)) {
  for (Index i = 0; i < coefficient_count(2 * harmonics); ++i) {
    const bool moment = which == Wave::kAny || is_even_coefficient(i);
    if (moment || i < coefficient_count(harmonics)) sums.push_back(i);
  }
}

SteadyCycle::SteadyCycle(std::size_t harmonics, std::size_t samples)
    : basis_(harmonics, samples),
      step_(2.0 * std::numbers::pi / static_cast<double>(samples)),
      any_(Wave::kAny, harmonics),
      odd_(Wave::kOdd, harmonics),
      x_(basis_.samples()),
      force_(basis_.samples()),
      slope_(basis_.samples()),
      kinks_(harmonics, samples),
      jump_gradient_(coefficient_count(harmonics)),
      moments_(coefficient_count(2 * harmonics)),
      through_reversals_(coefficient_count(harmonics), coefficient_count(harmonics)) {}

CycleMotion SteadyCycle::evaluate(const Joint& joint, std::span<const double> displacement,
                                  std::span<double> force, std::span<double> jacobian) {
  begin(displacement);
  if (extremes_.size() == 0) {
    at_rest(joint);
  } else {
    march(joint);
  }
  hand_over(force, jacobian);
  if (extremes_.size() == 0) return {x_[0], x_[0], 0};
  return {extremes_.lowest(), extremes_.highest(), extremes_.size()};
}

/// The samples of the motion and its extremes.
void SteadyCycle::begin(std::span<const double> displacement) {
  const bool odd = basis_.samples() % 2 == 0 && is_odd_wave(displacement);
  columns_ = odd ? &odd_ : &any_;
  motion_.clear();
  for (const Index i : columns_->motion) {
    motion_.push_back(displacement[static_cast<std::size_t>(i)]);
  }
  const Index half = basis_.samples() / 2;
  basis_.evaluate(columns_->motion, motion_, stretch_of(x_, 0, odd ? half : basis_.samples()));
  if (odd) x_.tail(half) = -x_.head(half);
  extremes_.find(stretch_of(std::as_const(x_), 0, x_.size()), motion_, columns_->wave);
  half_ = odd && extremes_.size() > 0;

  moments_.setZero();
  kinks_.reset(motion_, columns_->wave);
  through_reversals_.setZero();
  part_.resize(static_cast<Index>(columns_->sums.size()));
  sums_.resize(motion_.size());
  reaches_.clear();
}

// On the virgin curve at x_0; motion that starts there is at first elastic.
void SteadyCycle::at_rest(const Joint& joint) {
  force_.setConstant(joint.virgin_force(x_[0]));
  moments_[0] = static_cast<double>(basis_.samples()) * joint.stiffness();
}

void SteadyCycle::march(const Joint& joint) {
  const std::size_t count = extremes_.size();
  rows_.resize(coefficients(), static_cast<Index>(count));
  gradients_.resize(coefficients(), static_cast<Index>(count));
  const auto apart = static_cast<Index>(count / 2);
  for (Index i = 0; i < static_cast<Index>(count); ++i) {
    if (!half_ || i < apart) {
      basis_at(extremes_[static_cast<std::size_t>(i)].tau, rows_.col(i));
      continue;
    }
    for (Index k = 0; k < coefficients(); ++k) {
      rows_(k, i) = is_even_coefficient(k) ? rows_(k, i - apart) : -rows_(k, i - apart);
    }
  }
  const std::size_t start = extremes_.largest();
  const auto column = static_cast<Index>(start);
  const double x = extremes_[start].displacement;
  gradients_.col(column) = joint.tangent_stiffness(x) * rows_.col(column);
  stack_.assign(1, {start, joint.virgin_force(x)});
  reaches_.push_back({std::abs(x), start, start});

  const std::size_t steps = half_ ? count / 2 : count;
  Index left = half_ ? basis_.samples() / 2 : basis_.samples();
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t from = (start + step) % count;
    const std::size_t to = (from + 1) % count;
    Index samples = extremes_[to].next - extremes_[from].next;
    if (samples < 0) samples += basis_.samples();
    samples = step + 1 == steps ? left : std::min(samples, left);
    left -= samples;
    segment(joint, from, to, samples);
  }
  if (half_) turn_round(extremes_[start].next);
  std::ranges::sort(reaches_, std::greater{}, &Reach::half);
}

/// The forces at the first half of the samples from those at half a cycle that starts somewhere,
/// and the branches of the other half.
void SteadyCycle::turn_round(Index first) {
  const Index apart = basis_.samples() / 2;
  const Index low = first < apart ? 0 : first - apart;  // the samples that were not gone through
  const Index high = first < apart ? first : apart;
  force_.segment(low, high - low) = -force_.segment(low + apart, high - low);
  const std::size_t extremes = extremes_.size();
  const std::size_t branches = reaches_.size();
  const auto opposite = [&](std::size_t i) { return (i + extremes / 2) % extremes; };
  for (std::size_t i = 1; i < branches; ++i) {  // the path from virgin rest is one
    reaches_.push_back({reaches_[i].half, opposite(reaches_[i].at), opposite(reaches_[i].from)});
  }
}

/// From sums to harmonics. Even and odd ones of an odd wave are exactly decoupled, so that solvers
/// of equations can use that.
void SteadyCycle::hand_over(std::span<double> force, std::span<double> jacobian) {
  const bool odd = columns_->wave == Wave::kOdd;
  const double times = half_ ? 2.0 : 1.0;
  const VectorXd& weights = basis_.weights();
  basis_.sum(columns_->motion, 0,
             stretch_of(force_, 0, half_ ? basis_.samples() / 2 : basis_.samples()), sums_);
  std::ranges::fill(force, 0.0);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Index place = columns_->motion[i];
    force[static_cast<std::size_t>(place)] =
        times * weights[place] * (sums_[i] + kinks_.sums()[place]);
  }
  moments_[0] *= times * weights[0];
  moments_.tail(moments_.size() - 1) *= times * weights[1];
  const Eigen::MatrixXd by_tangent =
      multiplication_matrix(moments_, basis_.harmonics(), columns_->wave);
  double* entry = jacobian.data();
  for (Index i = 0; i < coefficients(); ++i) {
    const double weight = times * weights[i];
    for (Index j = 0; j < coefficients(); ++j, ++entry) {
      const bool apart = odd && is_even_coefficient(i) != is_even_coefficient(j);
      *entry = apart ? 0.0
                     : weight * (through_reversals_(i, j) + kinks_.derivatives()(i, j)) +
                           by_tangent(i, j);
    }
  }
}

/// From one extreme to the next: on the branch from the reversal there, then, each time the path
/// passes the extreme before it, on the branch of which that one was an inner loop.
void SteadyCycle::segment(const Joint& joint, std::size_t from, std::size_t to, Index samples) {
  const double target = extremes_[to].displacement;
  double x = extremes_[from].displacement;
  Stretch stretch{from, to, target > x ? 1.0 : -1.0, extremes_[from].next, samples};
  const double sign = stretch.sign;
  for (;;) {
    const Reversal origin = stack_.back();
    const bool inner = stack_.size() > 2;
    const double end = inner ? extremes_[stack_[stack_.size() - 2].at].displacement : 0.0;
    const bool closes = inner && sign * target > sign * end;
    const Index run = closes ? samples_up_to(end, stretch) : stretch.samples;
    branch(joint, origin, sign, stretch.first, run);
    kinks_of_atoms(joint, stretch, origin, x, closes ? end : target);
    if (!closes) {
      stack_.push_back(reversal_on(joint, origin, sign, to));
      return;
    }
    kink_of_closing(joint, stretch, end);
    x = end;
    stretch.first = (stretch.first + run) % basis_.samples();
    stretch.samples -= run;
    stack_.resize(stack_.size() - 2);
  }
}

Index SteadyCycle::samples_up_to(double end, const Stretch& stretch) const {
  Index run = 0;
  const double limit = stretch.sign * end;
  while (run < stretch.samples && stretch.sign * x_[(stretch.first + run) % x_.size()] <= limit) {
    ++run;
  }
  return run;
}

/// An atom of weight m that starts to slip takes km from the tangent.
void SteadyCycle::kinks_of_atoms(const Joint& joint, const Stretch& stretch, const Reversal& origin,
                                 double from, double to) {
  const AtomsPart& atoms = joint.density().atoms();
  const double k = joint.stiffness();
  const double turned_at = extremes_[origin.at].displacement;
  jump_gradient_.setZero();
  for (std::size_t i = 0; i < atoms.slip_force.size(); ++i) {
    const double x = turned_at + stretch.sign * 2.0 * atoms.slip_force[i] / k;
    const bool passed =
        stretch.sign * x > stretch.sign * from && stretch.sign * x < stretch.sign * to;
    if (!passed) continue;
    kinks_.add_kink(angle_at(stretch, x), -k * atoms.weight[i],
                    rows_.col(static_cast<Index>(origin.at)), jump_gradient_);
  }
}

/// Where an inner loop closes the tangent falls to that of the branch outside of it.
void SteadyCycle::kink_of_closing(const Joint& joint, const Stretch& stretch, double end) {
  const std::size_t size = stack_.size();
  const std::size_t closed = stack_[size - 2].at;  // the extreme that is passed
  const double k = joint.stiffness();
  double jump = 0.0;
  jump_gradient_.setZero();
  const auto add_tangent = [&](std::size_t origin, double factor) {
    const double half = 0.5 * std::abs(end - extremes_[origin].displacement);
    jump += factor * joint.tangent_stiffness(half);
    if (half == 0.0) return;  // a loop of rounding; the density may be infinite at 0
    const double curvature = -k * k * joint.density().density(k * half);  // F″ [AR14 (4)]
    jump_gradient_ +=
        (0.5 * factor * stretch.sign * curvature) *
        (rows_.col(static_cast<Index>(closed)) - rows_.col(static_cast<Index>(origin)));
  };
  add_tangent(stack_[size - 3].at, 1.0);
  add_tangent(stack_[size - 1].at, -1.0);
  kinks_.add_kink(angle_at(stretch, end), jump, rows_.col(static_cast<Index>(closed)),
                  jump_gradient_);
}

/// The angle in the interval of samples that ends with `next`.
double SteadyCycle::in_interval(double tau, Index next) const {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double middle = step_ * (static_cast<double>(next) - 0.5);
  return tau - kTurn * std::round((tau - middle) / kTurn);
}

/// Where the motion passes x on a stretch.
double SteadyCycle::angle_at(const Stretch& stretch, double x) const {
  const Index next = stretch.first + samples_up_to(x, stretch);
  const double end = step_ * static_cast<double>(next);
  const auto turn = [&](std::size_t i) { return in_interval(extremes_[i].tau, next); };
  const auto is_next = [&](std::size_t i) { return next % basis_.samples() == extremes_[i].next; };
  double low = end - step_;
  double high = end;
  if (is_next(stretch.from)) low = std::clamp(turn(stretch.from), low, end);
  if (is_next(stretch.to)) high = std::clamp(turn(stretch.to), low, end);
  const auto excess = [&](double tau) {
    const Motion motion = motion_at(motion_, tau, columns_->wave);
    return Growing{stretch.sign * (motion.value - x), stretch.sign * motion.velocity};
  };
  return growing_zero(excess, low, high);
}

SteadyCycle::Reversal SteadyCycle::reversal_on(const Joint& joint, const Reversal& origin,
                                               double sign, std::size_t at) {
  const double half =
      0.5 * std::abs(extremes_[at].displacement - extremes_[origin.at].displacement);
  const auto here = static_cast<Index>(at);
  const auto there = static_cast<Index>(origin.at);
  const double tangent = joint.tangent_stiffness(half);
  gradients_.col(here) = gradients_.col(there) + tangent * (rows_.col(here) - rows_.col(there));
  const CycleExtremes::Extreme& turn = extremes_[at];
  kinks_.add_turn(in_interval(turn.tau, turn.next), turn.next, turn.acceleration, rows_.col(here),
                  joint.stiffness() - tangent);
  reaches_.push_back({half, at, origin.at});
  return {at, origin.force + 2.0 * sign * joint.virgin_force(half)};
}

/// The extremes themselves stay where they are to first order, as the velocity is 0 there.
void SteadyCycle::reach_gradient(std::size_t rank, std::span<double> gradient) const {
  const Reach& reach = reaches_[rank];
  Eigen::Map<VectorXd> result(gradient.data(), static_cast<Index>(gradient.size()));
  const auto at = static_cast<Index>(reach.at);
  if (reach.at == reach.from) {
    result = rows_.col(at) * (extremes_[reach.at].displacement > 0.0 ? 1.0 : -1.0);
    return;
  }
  const auto from = static_cast<Index>(reach.from);
  const bool up = extremes_[reach.at].displacement > extremes_[reach.from].displacement;
  result = (up ? 0.5 : -0.5) * (rows_.col(at) - rows_.col(from));
}

void SteadyCycle::turn_gradient(std::size_t i, std::span<double> gradient) const {
  Eigen::Map<VectorXd>(gradient.data(), static_cast<Index>(gradient.size())) =
      rows_.col(static_cast<Index>(i));
}

/// Samples that may run over the end of the cycle.
void SteadyCycle::branch(const Joint& joint, const Reversal& origin, double sign, Index first,
                         Index samples) {
  first %= basis_.samples();
  const Index before_end = std::min(samples, basis_.samples() - first);
  block(joint, origin, sign, first, before_end);
  block(joint, origin, sign, 0, samples - before_end);
}

void SteadyCycle::block(const Joint& joint, const Reversal& origin, double sign, Index first,
                        Index samples) {
  if (samples == 0) return;
  const double k = joint.stiffness();
  const double turned_at = extremes_[origin.at].displacement;
  const VirginCurve& curve = joint.virgin_curve();
  for (Index i = first; i < first + samples; ++i) {
    const auto [virgin, slope] = curve.response(0.5 * k * std::abs(x_[i] - turned_at));
    force_[i] = origin.force + 2.0 * sign * virgin;
    slope_[i] = slope;
  }
  basis_.sum(columns_->sums, first, stretch_of(std::as_const(slope_), first, samples),
             stretch_of(part_, 0, part_.size()));
  part_ *= k;
  for (std::size_t i = 0; i < columns_->sums.size(); ++i) {
    const Index place = columns_->sums[i];
    if (!half_ || is_even_coefficient(place)) moments_[place] += part_[static_cast<Index>(i)];
  }
  // Σ T_a (f_r′ − F′ T_r), over the samples of the block.
  const auto column = static_cast<Index>(origin.at);
  const Index n = coefficients();
  const VectorXd sum = basis_.sums().row(first + samples) - basis_.sums().row(first);
  for (Index j = 0; j < n; ++j) {
    through_reversals_.col(j) += gradients_(j, column) * sum - rows_(j, column) * part_.head(n);
  }
}

}  // namespace microslip
