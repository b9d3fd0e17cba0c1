// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "microslip/dynamics/density_corners.hpp"
#include "microslip/dynamics/jointed_structure.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"

namespace microslip {

/// The hysteresis of one joint in a march: its Memory, or where the normal load varies a network of
/// Jenkins elements. Internal to dynamics.
///
/// Between two kinks the Memory moves on one smooth curve. A step is tried on that curve as if it
/// had no end: with the kink inside of the step the tangent would jump there, and the equations of
/// the step may have no solution at all. Where the kink lies is found afterwards, and the step cut
/// there.
class MarchedJoint {
 public:
  /// @param joint  kept by reference.
  explicit MarchedJoint(const StructuralJoint& joint);
  /// Under a varying normal load. @param load  p at the start.
  MarchedJoint(const StructuralJoint& joint, NormalLoadLaw law, std::size_t elements, double load);

  struct Response {
    double force;    ///< F, N
    double tangent;  ///< dF/du, N/m
  };

  /// After a move to u at the load p, which is not taken.
  [[nodiscard]] Response trial(double u, double load);
  /// Takes it. @return F, N.
  double advance(double u, double load);
  /// Says that the motion turns here, or that it begins: from here on it goes in this direction, +1
  /// or −1. What the way to here dissipated is counted.
  void turn(int direction);

  /// Where the tangent jumps next, or its slope: a loop closes, an atom begins to slip, the density
  /// jumps.
  struct Kink {
    double displacement;  ///< u, m; ±infinite where there is none
    double force;         ///< F there, N
  };
  [[nodiscard]] const Kink& next_kink() const { return kink_; }
  /// Goes over to the curve behind the next kink.
  void pass_kink();
  /// dF/du on the present curve, where the joint stands, N/m.
  [[nodiscard]] double tangent() const;
  /// Counts dissipation from here on.
  void begin_energy();

  [[nodiscard]] double displacement() const { return u_; }
  [[nodiscard]] double force() const { return force_; }
  /// Up to here, J; ∫ F du for a network.
  [[nodiscard]] double dissipation() const;
  [[nodiscard]] double stored_energy() const;

  /// k, N/m: right after a reversal.
  [[nodiscard]] double stuck_stiffness() const { return joint_->joint.stiffness(); }

  /// The displacement from rest over which the joint and what is in series with it part by y, u +
  /// cF(u) = y, on the virgin curve at the load p, p times that at 1.
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

  /// The smooth part of a Memory between two kinks.
  struct Piece {
    Memory::Curve curve;
    std::size_t passed;    ///< corners that lie behind
    std::size_t slipping;  ///< atoms that slip on it
  };

  void follow(int direction, double from);
  void pass_corner();
  void find_kink();
  [[nodiscard]] double elastic_force(double u) const;
  [[nodiscard]] Response on_piece(double u) const;

  static constexpr Kink kNoKink{std::numeric_limits<double>::infinity(), 0.0};

  const StructuralJoint* joint_;
  Memory memory_;
  Memory turned_;  ///< where the motion turned last
  std::vector<Corner> corners_;
  std::optional<Piece> piece_;  ///< none before the first motion, and for a network
  Kink kink_ = kNoKink;
  std::unique_ptr<Network> network_;
  double u_ = 0.0;
  double force_ = 0.0;
  double dissipation_ = 0.0;  ///< up to the last turn
  double work_ = 0.0;         ///< of a network
};

}  // namespace microslip
