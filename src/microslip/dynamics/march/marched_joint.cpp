// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/marched_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {

MarchedJoint::MarchedJoint(const StructuralJoint& joint)
    : joint_(&joint), follower_(joint.joint), turned_(joint.joint) {}

MarchedJoint::MarchedJoint(const StructuralJoint& joint, NormalLoadLaw law, std::size_t elements,
                           double load)
    : MarchedJoint(joint) {
  network_ = std::make_unique<Network>(joint.joint, elements, law);
  network_->memory.advance(0.0, load);
}

MarchedJoint::Response MarchedJoint::trial(double u, double load) {
  if (!network_) return follower_.response(u);
  network_->tried = network_->memory;
  const double force = network_->tried.advance(u, load);
  // The elements have no tangent: the chord of the step is used.
  const double stiff = load * joint_->joint.stiffness();
  const double chord = u == u_ ? stiff : (force - force_) / (u - u_);
  return {force, std::clamp(chord, 0.0, stiff)};
}

double MarchedJoint::advance(double u, double load) {
  if (!network_) {
    u_ = u;
    return force_ = follower_.advance(u);
  }
  const double force = network_->memory.advance(u, load);
  work_ += 0.5 * (force_ + force) * (u - u_);
  u_ = u;
  return force_ = force;
}

double MarchedJoint::settle(double u, double load, double force) {
  if (network_) return advance(u, load);
  follower_.settle(u, force);
  u_ = u;
  return force_ = force;
}

void MarchedJoint::turn(int direction) {
  if (network_) return;
  turned(u_, force_);
  follower_.turn(direction);
}

void MarchedJoint::turned(double u, double force) {
  dissipation_ += turned_.dissipation(u);
  turned_.settle(u, force);
}

void MarchedJoint::begin_energy() {
  turned_ = follower_.memory();
  dissipation_ = 0.0;
  work_ = 0.0;
}

double MarchedJoint::dissipation() const {
  return network_ ? work_ : dissipation_ + turned_.dissipation(u_);
}

double MarchedJoint::stored_energy() const {
  return network_ ? 0.0 : follower_.memory().stored_energy();
}

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
