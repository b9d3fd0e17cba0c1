// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "microslip/dynamics/march/virgin_curve_cursor.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"

namespace microslip {

/// The hysteresis of one joint in a march: its Memory on smooth curves, or where the normal load
/// varies a network of Jenkins elements. Internal to dynamics.
class MarchedJoint {
 public:
  /// @param joint  kept by reference.
  explicit MarchedJoint(const StructuralJoint& joint);
  /// Under a varying normal load. @param load  p at the start.
  MarchedJoint(const StructuralJoint& joint, NormalLoadLaw law, std::size_t elements, double load);

  using Response = CurveFollower::Response;

  /// After a move to u at the load p, which is not taken.
  [[nodiscard]] Response trial(double u, double load);
  /// Takes it. @return F, N.
  double advance(double u, double load);
  /// Takes it where its force is known, N. @return F, N; of a network that of its elements.
  double settle(double u, double load, double force);
  /// Reverses the motion here, or begins it: from here on it goes in this direction, +1 or −1. The
  /// dissipation up to here is added.
  void turn(int direction);
  /// Records a reversal at u, on the path of another follower, which is taken over afterwards.
  /// @param force  F there, N.
  void turned(double u, double force);
  /// Continues from the state of the other, which must not be used any more.
  void take_over(CurveFollower& other) { std::swap(follower_, other); }

  void pass_kink() { follower_.pass_kink(); }
  [[nodiscard]] double tangent() const { return follower_.tangent(); }
  /// The Memory on its curves; at rest for a network.
  [[nodiscard]] const CurveFollower& follower() const { return follower_; }
  [[nodiscard]] bool is_network() const { return network_ != nullptr; }
  /// Counts dissipation from here on.
  void begin_energy();

  [[nodiscard]] double displacement() const { return u_; }
  [[nodiscard]] double force() const { return force_; }
  /// Up to here, J; ∫ F du for a network.
  [[nodiscard]] double dissipation() const;
  [[nodiscard]] double stored_energy() const;

  /// k, N/m: right after a reversal.
  [[nodiscard]] double stuck_stiffness() const { return joint_->joint.stiffness(); }

  /// The displacement from rest at which the joint and the compliance in series move apart by y, u
  /// + cF(u) = y, on the virgin curve at the load p, p times that at 1.
  [[nodiscard]] double displacement_at(double y, double load) const;

 private:
  struct Network {
    Network(const Joint& joint, std::size_t elements, NormalLoadLaw law)
        : model(JenkinsNetwork::discretise(joint, elements)),
          memory(model, law),
          tried(model, law) {}
    JenkinsNetwork model;
    NetworkMemory memory;
    NetworkMemory tried;
  };

  const StructuralJoint* joint_;
  CurveFollower follower_;
  Memory turned_;  ///< at the last reversal
  std::unique_ptr<Network> network_;
  double u_ = 0.0;
  double force_ = 0.0;
  double dissipation_ = 0.0;  ///< up to the last reversal
  double work_ = 0.0;         ///< of a network
};

}  // namespace microslip
