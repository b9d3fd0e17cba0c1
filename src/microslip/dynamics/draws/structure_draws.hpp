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
  std::vector<double> frequency = {};    ///< of ω_i without the joints; one per mode or none
  std::vector<double> loss_factor = {};  ///< of η_i; one per mode or none
  /// Of the normal load, which scales a joint's slip forces; one per joint or none.
  std::vector<double> normal_load = {};
  std::vector<double> force_gain = {};  ///< of the reading of a force; one per excitation or none
  double response_gain = 0.0;           ///< of the reading of the response

  /// Whether anything is uncertain.
  [[nodiscard]] bool any() const;
};

/// A structure as it may be.
struct StructureDraw {
  JointedStructure structure;  ///< its excitations by what they are where 1 is read of the force
  double response_gain = 1.0;  ///< reading of the response over the response
  std::vector<double> force_gain = {};  ///< reading of a force over the force; one per excitation
};

/// Draws of a structure with uncertain parameters: draw i of seed s, the same whatever the order
/// and the number of draws, the machine, its threads and ranks. Immutable.
///
/// A reading is the gain times the true value: a force read as A drives with A/g, so that the
/// excitations of a draw are divided by their gains; for comparison with a reading of the response,
/// multiply by its gain.
///
/// The joints of a draw are those of DrawnJoints.
class StructureDraws {
 public:
  /// @param nominal  the nominal structure.
  /// @param spread   of its numbers.
  /// @param joints   one per joint, or none.
  /// @param pairing  of those that have draws.
  /// @param seed     s.
  /// @throws InputError  as DrawnJoints; for standard deviations below 0 or above kLargestSpread;
  ///                     for lists of another length than there are modes, joints, excitations.
  StructureDraws(JointedStructure nominal, StructureSpread spread, std::vector<JointDraws> joints,
                 JointPairing pairing, std::uint64_t seed);

  /// Largest σ, as of joints.
  static constexpr double kLargestSpread = DrawnJoints::kLargestSpread;

  /// Draw i.
  /// @throws InputError  as JointedStructure: a draw may break its rules, as a spring in the modes
  ///                     that is stiffer than a drawn structure.
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
