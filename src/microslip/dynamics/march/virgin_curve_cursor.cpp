// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/virgin_curve_cursor.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr double kForceRounding = 1e-12;

}  // namespace

CurveFollower::CurveFollower(const Joint& joint)
    : joint_(&joint), memory_(joint), corners_(corners_of(joint.density())) {}

CurveFollower::Response CurveFollower::on_memory(double u) const {
  const auto [force, tangent] = memory_.trial(u);
  return {force, tangent};
}

/// Moves to the curve on which the motion is at `from`, or at its present place if that is ahead.
void CurveFollower::follow(int direction, double from) {
  piece_ = Piece{memory_.curve_ahead(direction, from), 0, 0};
  const double at = direction * std::max(direction * from, direction * memory_.displacement());
  const double s = elastic_force(at) * (1.0 + kForceRounding);
  while (piece_->passed < corners_.size() && corners_[piece_->passed].slip_force <= s)
    pass_corner();
  find_kink();
}

void CurveFollower::pass_corner() {
  piece_->slipping += static_cast<std::size_t>(corners_[piece_->passed].atom);
  ++piece_->passed;
}

void CurveFollower::find_kink() {
  const Memory::Curve& on = piece_->curve;
  double end = on.end;  // sign·u
  if (piece_->passed < corners_.size()) {
    const double distance = corners_[piece_->passed].slip_force / (joint_->stiffness() * on.reach);
    end = std::min(end, on.sign * on.displacement + distance);
  }
  kink_ = on.sign * end;
}

void CurveFollower::pass_kink() {
  const Memory::Curve& on = piece_->curve;
  if (on.sign * kink_ < on.end) {
    pass_corner();
    find_kink();
  } else {
    follow(on.sign < 0.0 ? -1 : 1, kink_);
  }
}

/// s of the present curve; below 0 behind its beginning.
double CurveFollower::elastic_force(double u) const {
  const Memory::Curve& on = piece_->curve;
  return joint_->stiffness() * on.reach * on.sign * (u - on.displacement);
}

/// The curve continues behind its beginning as the odd function F, and its atoms keep slipping or
/// sticking: each that slips carries its slip force, each other w_a s.
CurveFollower::Response CurveFollower::on_piece(double u) const {
  const double s = elastic_force(u);
  const auto virgin = joint_->virgin_curve().response(std::abs(s));
  double force = std::copysign(virgin.force, s);
  double slope = virgin.slope;
  const AtomsPart& atoms = joint_->density().atoms();
  if (!corners_.empty()) {
    for (std::size_t a = 0; a < atoms.slip_force.size(); ++a) {
      const double slip = atoms.slip_force[a];
      const double weight = atoms.weight[a];
      if (slip <= std::abs(s)) {  // it slips in F
        force += weight * (s - std::copysign(slip, s));
        slope += weight;
      }
      if (a < piece_->slipping) {  // it slips on this piece
        force -= weight * (s - slip);
        slope -= weight;
      }
    }
  }
  const Memory::Curve& on = piece_->curve;
  return {on.force + on.scale * force, joint_->stiffness() * std::clamp(slope, 0.0, 1.0)};
}

}  // namespace microslip
