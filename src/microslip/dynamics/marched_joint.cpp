// SPDX-License-Identifier: MIT
#include "microslip/dynamics/marched_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace microslip {
namespace {

constexpr double kForceRounding = 1e-12;

}  // namespace

MarchedJoint::MarchedJoint(const StructuralJoint& joint)
    : joint_(&joint),
      memory_(joint.joint),
      turned_(joint.joint),
      corners_(corners_of(joint.joint.density())) {}

MarchedJoint::MarchedJoint(const StructuralJoint& joint, NormalLoadLaw law, std::size_t elements,
                           double load)
    : MarchedJoint(joint) {
  network_ = std::make_unique<Network>(joint.joint, elements, law);
  network_->memory.advance(0.0, load);
}

MarchedJoint::Response MarchedJoint::trial(double u, double load) {
  if (piece_) return on_piece(u);
  if (!network_) {
    const auto [force, tangent] = memory_.trial(u);
    return {force, tangent};
  }
  network_->tried = network_->memory;
  const double force = network_->tried.advance(u, load);
  // The elements know no tangent: the chord of the step stands for it.
  const double stiff = load * joint_->joint.stiffness();
  const double chord = u == u_ ? stiff : (force - force_) / (u - u_);
  return {force, std::clamp(chord, 0.0, stiff)};
}

double MarchedJoint::advance(double u, double load) {
  if (!network_) {
    u_ = u;
    return force_ = memory_.advance(u);
  }
  const double force = network_->memory.advance(u, load);
  work_ += 0.5 * (force_ + force) * (u - u_);
  u_ = u;
  return force_ = force;
}

void MarchedJoint::turn(int direction) {
  if (network_) return;
  dissipation_ += turned_.dissipation(u_);
  turned_ = memory_;
  follow(direction, u_);
}

// ---- From kink to kink. ----

/// Goes over to the curve on which the motion is at `from`, or where it stands if that is ahead.
void MarchedJoint::follow(int direction, double from) {
  piece_ = Piece{memory_.curve_ahead(direction, from), 0, 0};
  const double at = direction * std::max(direction * from, direction * u_);
  const double s = elastic_force(at) * (1.0 + kForceRounding);
  while (piece_->passed < corners_.size() && corners_[piece_->passed].slip_force <= s)
    pass_corner();
  find_kink();
}

void MarchedJoint::pass_corner() {
  piece_->slipping += static_cast<std::size_t>(corners_[piece_->passed].atom);
  ++piece_->passed;
}

void MarchedJoint::find_kink() {
  const Memory::Curve& on = piece_->curve;
  double end = on.end;  // sign·u
  if (piece_->passed < corners_.size()) {
    const double way = corners_[piece_->passed].slip_force / (joint_->joint.stiffness() * on.reach);
    end = std::min(end, on.sign * on.displacement + way);
  }
  kink_ = kNoKink;
  kink_.displacement = on.sign * end;
  if (std::isfinite(end)) kink_.force = on_piece(kink_.displacement).force;
}

void MarchedJoint::pass_kink() {
  const Memory::Curve& on = piece_->curve;
  if (on.sign * kink_.displacement < on.end) {
    pass_corner();
    find_kink();
  } else {
    follow(on.sign < 0.0 ? -1 : 1, kink_.displacement);
  }
}

double MarchedJoint::tangent() const { return piece_ ? on_piece(u_).tangent : 0.0; }

/// s of the present curve; below 0 behind its beginning.
double MarchedJoint::elastic_force(double u) const {
  const Memory::Curve& on = piece_->curve;
  return joint_->joint.stiffness() * on.reach * on.sign * (u - on.displacement);
}

/// The curve goes on behind its beginning as the odd function that F is, and its atoms slip or
/// stick as they do: each that slips carries its slip force, each other w_a s.
MarchedJoint::Response MarchedJoint::on_piece(double u) const {
  const double s = elastic_force(u);
  const auto virgin = joint_->joint.virgin_curve().response(std::abs(s));
  double force = std::copysign(virgin.force, s);
  double slope = virgin.slope;
  const AtomsPart& atoms = joint_->joint.density().atoms();
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
  return {on.force + on.scale * force, joint_->joint.stiffness() * std::clamp(slope, 0.0, 1.0)};
}

void MarchedJoint::begin_energy() {
  turned_ = memory_;
  dissipation_ = 0.0;
  work_ = 0.0;
}

double MarchedJoint::dissipation() const {
  return network_ ? work_ : dissipation_ + turned_.dissipation(u_);
}

double MarchedJoint::stored_energy() const { return network_ ? 0.0 : memory_.stored_energy(); }

// Newton's method from 0: u + cF(u) is concave in |u|, so that it comes from below. At a constant
// load both laws scale the virgin force by it. Three terms of up to |y| round to half an ε each.
double MarchedJoint::displacement_at(double y, double load) const {
  const double rounding = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(y);
  const double c = load * joint_->series_compliance;
  double u = 0.0;
  for (int i = 0; i < 100 && std::abs(y) > 0.0; ++i) {
    const double miss = y - u - c * joint_->joint.virgin_force(u);
    u += miss / (1.0 + c * joint_->joint.tangent_stiffness(u));
    if (std::abs(miss) <= rounding) break;
  }
  return u;
}

}  // namespace microslip
