// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/amplitude_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "microslip/algebra/lu.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kStuckShare = 1e-3;       // of the macro-slip force: hardly any slip
constexpr double kLargestRatio = 4.0;      // of two levels
constexpr double kStuckLoss = 0.01;        // of joints in the linear vibration to start from
constexpr double kSmallestRatio = 1.0005;  // below it the continuation is stuck

/// The number of the stuck mode next to ω.
std::size_t mode_at(const JointedStructure& structure, double angular_frequency) {
  const std::vector<double> frequencies = structure.stuck_frequencies();
  const auto nearest = std::ranges::min_element(
      frequencies, {}, [&](double frequency) { return std::abs(frequency - angular_frequency); });
  return static_cast<std::size_t>(nearest - frequencies.begin());
}

/// The most of a motion of the joints, 1, at which they hardly slip.
double stuck_share(const JointedStructure& structure, const VectorXd& motion) {
  double share = HUGE_VAL;
  const auto joints = structure.joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j].joint;
    const double force = joint.stiffness() * std::abs(motion[static_cast<Index>(j)]);
    if (joint.macroslip_force() > 0.0 && force > 0.0) {
      share = std::min(share, kStuckShare * joint.macroslip_force() / force);
    }
  }
  return share;
}

/// Loss of the modes and the joints in a mode v of amplitude a, as the ξ that balances it: Σ v_i²
/// η_i ω_i + Σ D_j/(π ω a²), or where that is 0, as for atoms, a small loss of the joints.
double stuck_excitation(const JointedStructure& structure, const std::vector<double>& mode,
                        const VectorXd& motion, double amplitude, double angular_frequency) {
  double excitation = 0.0;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const Mode& m = structure.linear().modes()[i];
    excitation += mode[i] * mode[i] *
                  modal_stiffness(m, angular_frequency, structure.damping()).imag() /
                  angular_frequency;
  }
  double elastic = 0.0;
  const auto joints = structure.joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j].joint;
    const double across = std::abs(motion[static_cast<Index>(j)]);
    elastic += joint.stiffness() * across * across;
    excitation += dissipation(joint, amplitude * across) /
                  (std::numbers::pi * angular_frequency * amplitude * amplitude);
  }
  return excitation > 0.0 ? excitation : kStuckLoss * elastic / angular_frequency;
}

/// A mode v of the structure with joints of linear stiffness, and what it makes of them.
struct LinearMode {
  std::vector<double> shape;
  double angular_frequency;
  VectorXd motion;   ///< of each joint by v, m
  double amplitude;  ///< of v, kg^½ m: the joints hardly slip
};

/// @param linear  the structure, or that with other joints. @param number  of the mode.
LinearMode mode_of(const JointedStructure& linear, std::size_t number,
                   const JointedStructure& structure) {
  LinearMode mode{linear.stuck_mode(number), linear.stuck_frequencies()[number], {}, 1.0};
  const auto joints = linear.joints();
  mode.motion = VectorXd::Zero(static_cast<Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const StructuralJoint& joint = joints[j];
    const double across =
        std::inner_product(mode.shape.begin(), mode.shape.end(), joint.shape.begin(), 0.0);
    mode.motion[static_cast<Index>(j)] =
        across / (1.0 + joint.joint.stiffness() * joint.series_compliance);
  }
  const double share = stuck_share(structure, mode.motion);
  if (std::isfinite(share)) mode.amplitude = share;
  return mode;
}

/// With joints as stiff as they are in this vibration. Where many elements slip early, as of χ next
/// to −1, a joint has lost a part of its stiffness however little it moves.
JointedStructure with_secants(const JointedStructure& structure, const LinearMode& mode) {
  std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double across = mode.amplitude * std::abs(mode.motion[static_cast<Index>(j)]);
    joints[j].joint = Joint(secant_stiffness(joints[j].joint, across), SlipDensity());
  }
  return structure.with_joints(std::move(joints));
}

/// The mode of the stuck structure there, so small that it hardly slips.
VectorXd stuck_mode(const BalanceEquations& equations, double angular_frequency) {
  constexpr int kRounds = 4;  // each leaves a small part of what the one before has changed
  const JointedStructure& structure = equations.structure();
  const std::size_t number = mode_at(structure, angular_frequency);
  LinearMode mode = mode_of(structure, number, structure);
  for (int round = 0; round < kRounds; ++round) {
    mode = mode_of(with_secants(structure, mode), number, structure);
  }
  const Index n = equations.balance_count();
  VectorXd z = VectorXd::Zero(n + 2);
  for (Index j = 0; j < mode.motion.size(); ++j) {
    z[j * (n / mode.motion.size()) + coefficient_index(1) + 1] =  // −i: a lag of a quarter
        -mode.amplitude * mode.motion[j];
  }
  z[n] = mode.angular_frequency;
  z[n + 1] =
      stuck_excitation(structure, mode.shape, mode.motion, mode.amplitude, mode.angular_frequency);
  equations.set_at_rest(z);
  return z;
}

}  // namespace

VectorXd stuck_vibration(BalanceEquations& equations, double angular_frequency) {
  if (equations.forcing() == Forcing::kModal) return stuck_mode(equations, angular_frequency);
  const Index n = equations.balance_count();
  VectorXd z = VectorXd::Zero(n + 2);
  z[n] = angular_frequency;
  z[n + 1] = 1.0;
  equations.evaluate(z);
  z.head(n) = -equations.damped_jacobian(kStuckLoss).partialPivLu().solve(equations.residual());
  equations.set_at_rest(z);
  return z;
}

VectorXd scaled(BalanceEquations& equations, VectorXd z, const Target& level) {
  equations.evaluate(z);
  const double ratio = level.value / equations.value(level.quantity);
  const Index n = equations.balance_count();
  z = equations.enlarged(z, ratio);
  equations.evaluate(z);
  const auto joints = static_cast<Index>(equations.structure().joints().size());
  for (Index j = 0; j < joints; ++j) {
    const Index vibrating = j * (n / joints) + 1;  // without the mean
    auto motion = z.segment(vibrating, n / joints - 1);
    if (motion.isZero(0.0)) motion = -equations.residual().segment(vibrating, motion.size());
  }
  return z;
}

AmplitudeContinuation::AmplitudeContinuation(BalanceEquations& equations,
                                             const NewtonOptions& options, const Target& kept,
                                             Quantity level)
    : equations_(equations), options_(options), kept_(kept), quantity_(level) {}

NewtonResult AmplitudeContinuation::start(double angular_frequency, double most) {
  VectorXd z = stuck_vibration(equations_, angular_frequency);
  equations_.evaluate(z);
  const auto joints = equations_.structure().joints();
  const auto count = static_cast<Index>(joints.size());
  const Index block = equations_.balance_count() / std::max<Index>(1, count);
  VectorXd motion(count);
  for (Index j = 0; j < count; ++j) motion[j] = z.segment(j * block + 1, block - 1).norm();
  const double share = stuck_share(equations_.structure(), motion);
  const double present = equations_.value(quantity_);
  const double level = std::min(std::isfinite(share) ? share * present : HUGE_VAL,
                                joints.empty() ? most : kStuckShare * most);
  return start_at(level, scaled(equations_, z, {quantity_, level}));
}

NewtonResult AmplitudeContinuation::start_at(double level, const VectorXd& z) {
  z_ = z;
  level_ = level;
  previous_level_ = 0.0;
  VectorXd trial = z;
  const NewtonResult result = newton(equations_, kept_, Target{quantity_, level}, options_, trial);
  if (result.converged) z_ = trial;
  return result;
}

/// In proportion to the level at first, then linear through the last two.
VectorXd AmplitudeContinuation::predicted(double level) const {
  const Index n = equations_.balance_count();
  if (previous_level_ == 0.0) return equations_.enlarged(z_, level / level_);
  VectorXd z = z_ + (z_ - previous_) * ((level - level_) / (level_ - previous_level_));
  if (!(z[n] > 0.0)) z[n] = z_[n];
  if (!(z[n + 1] > 0.0)) z[n + 1] = z_[n + 1];
  return z;
}

NewtonResult AmplitudeContinuation::go_to(double level) {
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
