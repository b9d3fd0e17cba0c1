// SPDX-License-Identifier: MIT
#include "microslip/dynamics/level_walk.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kStuckShare = 1e-3;       // of the macro-slip force: hardly any slip
constexpr double kLargestRatio = 4.0;      // of two levels
constexpr double kStuckLoss = 0.01;        // of joints in the linear vibration to start from
constexpr double kSmallestRatio = 1.0005;  // below it the walk is stuck

}  // namespace

VectorXd stuck_vibration(BalanceEquations& equations, double angular_frequency) {
  const Index n = equations.balance_count();
  VectorXd z = VectorXd::Zero(n + 2);
  z[n] = angular_frequency;
  z[n + 1] = 1.0;
  equations.evaluate(z);
  const Eigen::MatrixXd matrix =
      equations.jacobian().leftCols(n) + equations.stuck_damping(kStuckLoss);
  z.head(n) = -matrix.partialPivLu().solve(equations.residual());
  return z;
}

VectorXd scaled(BalanceEquations& equations, VectorXd z, const Target& level) {
  equations.evaluate(z);
  const double ratio = level.value / equations.value(level.quantity);
  const Index n = equations.balance_count();
  z.head(n) *= ratio;
  z[n + 1] *= ratio;
  equations.evaluate(z);
  const auto joints = static_cast<Index>(equations.structure().joints().size());
  for (Index j = 0; j < joints; ++j) {
    auto motion = z.segment(j * (n / joints), n / joints);
    if (motion.isZero(0.0)) motion = -equations.residual().segment(j * (n / joints), n / joints);
  }
  return z;
}

LevelWalk::LevelWalk(BalanceEquations& equations, const NewtonOptions& options, const Target& kept,
                     Quantity level)
    : equations_(equations), options_(options), kept_(kept), quantity_(level) {}

NewtonResult LevelWalk::start(double angular_frequency, double most) {
  VectorXd z = stuck_vibration(equations_, angular_frequency);
  equations_.evaluate(z);
  double share = HUGE_VAL;  // of the present level that hardly slips
  const auto joints = equations_.structure().joints();
  const Index block =
      equations_.balance_count() / std::max<Index>(1, static_cast<Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j].joint;
    const double force = joint.stiffness() * z.segment(static_cast<Index>(j) * block, block).norm();
    if (joint.macroslip_force() > 0.0 && force > 0.0) {
      share = std::min(share, kStuckShare * joint.macroslip_force() / force);
    }
  }
  const double present = equations_.value(quantity_);
  const double level = std::min(std::isfinite(share) ? share * present : HUGE_VAL,
                                joints.empty() ? most : kStuckShare * most);
  return start_at(level, scaled(equations_, z, {quantity_, level}));
}

NewtonResult LevelWalk::start_at(double level, const VectorXd& z) {
  z_ = z;
  level_ = level;
  previous_level_ = 0.0;
  VectorXd trial = z;
  const NewtonResult result = newton(equations_, kept_, Target{quantity_, level}, options_, trial);
  if (result.converged) z_ = trial;
  return result;
}

/// In proportion to the level at first, then linear through the last two.
VectorXd LevelWalk::predicted(double level) const {
  const Index n = equations_.balance_count();
  if (previous_level_ == 0.0) {
    VectorXd z = z_;
    z.head(n) *= level / level_;
    z[n + 1] *= level / level_;
    return z;
  }
  VectorXd z = z_ + (z_ - previous_) * ((level - level_) / (level_ - previous_level_));
  if (!(z[n] > 0.0)) z[n] = z_[n];
  if (!(z[n + 1] > 0.0)) z[n + 1] = z_[n + 1];
  return z;
}

NewtonResult LevelWalk::go_to(double level) {
  NewtonResult total{.converged = true, .residual = 0.0, .iterations = 0, .reason = ""};
  double ratio = kLargestRatio;
  while (level_ != level) {
    const double factor = std::clamp(level / level_, 1.0 / ratio, ratio);
    const bool last = factor == level / level_;
    const double next = last ? level : level_ * factor;
    VectorXd z = predicted(next);
    NewtonResult step = newton(equations_, kept_, Target{quantity_, next}, options_, z);
    step.iterations += total.iterations;
    total = step;
    if (step.converged) {
      previous_ = z_;
      previous_level_ = level_;
      z_ = z;
      level_ = next;
      ratio = std::min(kLargestRatio, ratio * ratio);
      continue;
    }
    ratio = std::sqrt(ratio);
    if (ratio < kSmallestRatio) break;
  }
  return total;
}

}  // namespace microslip
