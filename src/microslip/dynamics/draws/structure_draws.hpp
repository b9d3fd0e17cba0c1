// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "microslip/dynamics/draws/drawn_joints.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// How uncertain the numbers of a structure are. A standard deviation σ is relative, and that of a
/// logarithm: a draw of v is v e^{σz}, z standard normal, so that none changes its sign and half of
/// the draws lie above v. All z are independent. 0 or an empty list: certain.
struct StructureSpread {
  std::vector<double> frequency = {};    ///< of ω_i without the joints; one a mode or none
  std::vector<double> loss_factor = {};  ///< of η_i; one a mode or none
  /// Of what scales a joint's slip forces; one a joint or none.
  std::vector<double> normal_load = {};
  std::vector<double> force_gain = {};  ///< of the reading of a force; one an excitation or none
  double response_gain = 0.0;           ///< of the reading of the response

  /// Whether anything is uncertain.
  [[nodiscard]] bool any() const;
};

/// A structure as it may be.
struct StructureDraw {
  JointedStructure structure;  ///< its excitations by what they are where 1 is read of the force
  double response_gain = 1.0;  ///< reading of the response over the response
  std::vector<double> force_gain = {};  ///< reading of a force over the force; one an excitation
};

/// Structures as they may be: draw i of seed s, the same whatever the order and the number of those
/// that are drawn, the machine, its threads and ranks. Immutable.
///
/// A reading is gain times what is there: a force of amplitude A that is read drives with A/g, so
/// that the excitations of a draw are divided by their gains; whoever compares with a reading of
/// the response multiplies by its gain.
///
/// The joints of a draw are those of DrawnJoints.
class StructureDraws {
 public:
  /// @param nominal  as it is thought to be.
  /// @param spread   of its numbers.
  /// @param joints   one a joint, or none.
  /// @param pairing  of those that have draws.
  /// @param seed     s.
  /// @throws InputError  as DrawnJoints; for standard deviations below 0 or above kLargestSpread;
  ///                     for lists of another length than there are modes, joints, excitations.
  StructureDraws(JointedStructure nominal, StructureSpread spread, std::vector<JointDraws> joints,
                 JointPairing pairing, std::uint64_t seed);

  /// As of joints.
  static constexpr double kLargestSpread = DrawnJoints::kLargestSpread;

  /// Draw i.
  /// @throws InputError  as JointedStructure: what is drawn may break its rules, as a spring in the
  ///                     modes that is stiffer than a drawn structure.
  [[nodiscard]] StructureDraw draw(std::uint64_t i) const;

  /// The structure as given.
  [[nodiscard]] const JointedStructure& nominal() const { return nominal_; }
  /// Whether draws differ.
  [[nodiscard]] bool any() const;

 private:
  [[nodiscard]] ModalModel drawn_modes(std::uint64_t i) const;
  [[nodiscard]] std::vector<StructuralJoint> drawn_joints(std::uint64_t i) const;
  [[nodiscard]] std::vector<double> drawn_gains(std::uint64_t i) const;

  JointedStructure nominal_;
  StructureSpread spread_;
  DrawnJoints joints_;
  std::uint64_t seed_;
};

}  // namespace microslip
