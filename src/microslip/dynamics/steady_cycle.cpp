// SPDX-License-Identifier: MIT
#include "microslip/dynamics/steady_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "microslip/dynamics/bracketed_newton.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Whether x(τ + π) = −x(τ): no even harmonics.
bool is_odd_wave(std::span<const double> coefficients) {
  for (Index i = 0; i < static_cast<Index>(coefficients.size()); ++i) {
    if (is_even_coefficient(i) && coefficients[static_cast<std::size_t>(i)] != 0.0) return false;
  }
  return true;
}

/// Then f(τ + π) = −f(τ), and even and odd harmonics do not know of each other: what rounding
/// leaves of that goes, so that those who solve equations with it see it.
void keep_odd_wave(Eigen::Map<VectorXd>& force, Eigen::Map<RowMajorMatrix>& jacobian) {
  for (Index i = 0; i < force.size(); ++i) {
    if (is_even_coefficient(i)) force[i] = 0.0;
    for (Index j = 0; j < force.size(); ++j) {
      if (is_even_coefficient(i) != is_even_coefficient(j)) jacobian(i, j) = 0.0;
    }
  }
}

}  // namespace

SteadyCycle::SteadyCycle(std::size_t harmonics, std::size_t samples)
    : basis_(harmonics, samples),
      step_(2.0 * std::numbers::pi / static_cast<double>(samples)),
      x_(basis_.samples()),
      force_(basis_.samples()),
      tangent_(basis_.samples()),
      kinks_(harmonics, samples),
      jump_gradient_(coefficient_count(harmonics)),
      part_(coefficient_count(2 * harmonics)),
      moments_(coefficient_count(2 * harmonics)),
      through_reversals_(coefficient_count(harmonics), coefficient_count(harmonics)) {}

HarmonicForce::Cycle SteadyCycle::evaluate(const Joint& joint, std::span<const double> displacement,
                                           std::span<double> force, std::span<double> jacobian) {
  const Index n = coefficient_count(basis_.harmonics());
  const Eigen::Map<const VectorXd> coefficients(displacement.data(), n);
  x_.noalias() = basis_.rows().leftCols(n) * coefficients;
  extremes_.find({x_.data(), static_cast<std::size_t>(x_.size())}, displacement);
  coefficients_of_x_ = displacement;
  moments_.setZero();
  kinks_.reset(displacement);
  through_reversals_.setZero();
  reaches_.clear();
  const bool odd = basis_.samples() % 2 == 0 && is_odd_wave(displacement);
  const bool half = odd && extremes_turn_round();
  if (extremes_.size() == 0) {
    at_rest(joint);
  } else {
    march(joint, half);
  }
  const double times = half ? 2.0 : 1.0;
  Eigen::Map<VectorXd> f(force.data(), n);
  f.noalias() = basis_.rows().leftCols(n).transpose() * force_;
  f += times * kinks_.sums();
  f.array() *= basis_.weights().array();
  moments_[0] *= times * basis_.weights()[0];
  moments_.tail(moments_.size() - 1) *= times * basis_.weights()[1];
  Eigen::Map<RowMajorMatrix> j(jacobian.data(), n, n);
  through_reversals_ += kinks_.derivatives();
  j = times * basis_.weights().asDiagonal() * through_reversals_;
  j += multiplication_matrix(moments_, basis_.harmonics());
  if (odd) keep_odd_wave(f, j);
  if (extremes_.size() == 0) return {x_[0], x_[0], 0};
  return {extremes_.lowest(), extremes_.highest(), extremes_.size()};
}

// On the virgin curve at x_0; motion that starts there is at first elastic.
void SteadyCycle::at_rest(const Joint& joint) {
  force_.setConstant(joint.virgin_force(x_[0]));
  tangent_.setConstant(joint.stiffness());
  moments_.noalias() = basis_.rows().transpose() * tangent_;
}

/// Whether each extreme has its counterpart half a period later, as an odd wave has but for what
/// rounding makes of extremes that hardly are.
bool SteadyCycle::extremes_turn_round() const {
  constexpr double kSame = 1e-9;
  const std::size_t count = extremes_.size();
  if (count == 0 || count % 2 == 1) return false;
  const double limit = kSame * std::abs(extremes_[extremes_.largest()].displacement);
  for (std::size_t i = 0; i < count / 2; ++i) {
    const double sum = extremes_[i].displacement + extremes_[i + count / 2].displacement;
    if (std::abs(sum) > limit) return false;
  }
  return true;
}

/// Through the whole cycle, or, where the second half is the first turned round, through that: its
/// sums are half of those in odd harmonics of the force, and in derivatives of odd harmonics by odd
/// and even by even ones. What else they hold vanishes over the whole.
void SteadyCycle::march(const Joint& joint, bool half) {
  const std::size_t count = extremes_.size();
  const Index n = coefficient_count(basis_.harmonics());
  rows_.resize(n, static_cast<Index>(count));
  gradients_.resize(n, static_cast<Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    basis_at(extremes_[i].tau, rows_.col(static_cast<Index>(i)));
  }
  const std::size_t start = extremes_.largest();
  const auto column = static_cast<Index>(start);
  const double x = extremes_[start].displacement;
  gradients_.col(column) = joint.tangent_stiffness(x) * rows_.col(column);
  stack_.assign(1, {start, joint.virgin_force(x)});
  reaches_.push_back({std::abs(x), start, start});

  const std::size_t steps = half ? count / 2 : count;
  const Index all = half ? basis_.samples() / 2 : basis_.samples();
  Index left = all;
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t from = (start + step) % count;
    const std::size_t to = (from + 1) % count;
    Index samples = extremes_[to].next - extremes_[from].next;
    if (samples < 0) samples += basis_.samples();
    samples = step + 1 == steps ? left : std::min(samples, left);
    left -= samples;
    segment(joint, from, to, samples);
  }
  if (half) turn_round(extremes_[start].next, all);
  std::ranges::sort(reaches_, std::greater{}, &Reach::half);
}

/// The forces at the samples of the other half, and its branches.
void SteadyCycle::turn_round(Index first, Index samples) {
  const Index count = basis_.samples();
  for (Index k = first; k < first + samples; ++k) {
    force_[(k + samples) % count] = -force_[k % count];
  }
  const std::size_t extremes = extremes_.size();
  const std::size_t branches = reaches_.size();
  const auto opposite = [&](std::size_t i) { return (i + extremes / 2) % extremes; };
  for (std::size_t i = 1; i < branches; ++i) {  // the way from virgin rest is one
    reaches_.push_back({reaches_[i].half, opposite(reaches_[i].at), opposite(reaches_[i].from)});
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
    const Motion motion = motion_at(coefficients_of_x_, tau);
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
  kinks_.add_turn(in_interval(turn.tau, turn.next), turn.next, rows_.col(here),
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
  const double turned_at = extremes_[origin.at].displacement;
  const double k = joint.stiffness();
  const VirginCurve& curve = joint.virgin_curve();
  for (Index i = first; i < first + samples; ++i) {
    const auto [force, slope] = curve.response(0.5 * k * std::abs(x_[i] - turned_at));
    force_[i] = origin.force + 2.0 * sign * force;
    tangent_[i] = k * slope;
  }
  part_.noalias() =
      basis_.rows().middleRows(first, samples).transpose() * tangent_.segment(first, samples);
  moments_ += part_;
  // Σ T_a (f_r′ − F′ T_r), over the samples of the block.
  const Index n = through_reversals_.rows();
  const auto column = static_cast<Index>(origin.at);
  const auto sum = basis_.sums().row(first + samples) - basis_.sums().row(first);
  through_reversals_.noalias() += sum.transpose() * gradients_.col(column).transpose();
  through_reversals_.noalias() -= part_.head(n) * rows_.col(column).transpose();
}

}  // namespace microslip
