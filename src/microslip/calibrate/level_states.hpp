// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/observe/modal_levels.hpp"

/// @file
/// The vibration of a structure at each modal level, with the joints as they are known so far.
/// Internal to calibrate.

namespace microslip {

/// The resonances of the levels.
class LevelStates {
 public:
  /// @param structure  with the initial guess of its joints.
  /// @param response   where the displacements of the levels were measured.
  /// @param balance    how the vibrations are computed.
  /// @param levels     must outlive this.
  LevelStates(JointedStructure structure, std::string response, HarmonicBalanceOptions balance,
              const ModalLevels& levels, Execution execution);

  /// Sets other joints; vibrations are unchanged until solve().
  /// @param joints  one per joint of the structure.
  void set_joints(const std::vector<Joint>& joints);

  /// Finds the resonance of each of these levels with the present joints, at the measured
  /// displacement. A level that was solved before starts from there, else from the nearest solved
  /// one of its mode, else from the stuck structure; where none leads to it, along the curve of
  /// resonances from rest. One that is not found keeps nothing; another mode is not taken for it.
  /// @param which  levels.
  void solve(const std::vector<std::size_t>& which);

  /// Takes other frequencies of the modes without joints than those given, or, where no structure
  /// has them, as there may be none without its springs, a part of how they differ from those;
  /// vibrations are unchanged until solve().
  /// @param modes  offset of each, of ln ω_i, and of half of ln k_s of each joint.
  void correct(const std::vector<double>& modes);
  /// The offsets that were taken; empty without.
  [[nodiscard]] const std::vector<double>& offsets() const { return offsets_; }
  /// How many offsets there are to correct.
  [[nodiscard]] std::size_t unknown_offsets() const {
    return structure().linear().size() + structure().joints().size();
  }
  /// The offset of ln ω of levels of a mode that the corrected structure has, at the mean stiffness
  /// of the joints in them; 0 without.
  [[nodiscard]] double offset_taken(std::size_t mode) const {
    return taken_.empty() ? 0.0 : taken_[mode];
  }
  /// The structure as given, with the present joints.
  [[nodiscard]] JointedStructure given() const;

  [[nodiscard]] const JointedStructure& structure() const { return balance_.structure(); }
  [[nodiscard]] const std::string& response() const { return balance_.response().point; }
  [[nodiscard]] const HarmonicBalance& balance() const { return balance_; }

  /// The vibration of a level; nothing where it was not found.
  [[nodiscard]] const std::optional<SteadyVibration>& at(std::size_t level) const {
    return states_[level];
  }

  /// Half range of a joint's displacement at a level, m: found, or in proportion to the nearest
  /// solved level of the mode, or by the shape of the stuck structure.
  [[nodiscard]] double amplitude(std::size_t level, std::size_t joint) const;
  /// Half range by the shape of the stuck structure.
  [[nodiscard]] double stuck_amplitude(std::size_t level, std::size_t joint) const {
    return stuck_shape_[levels_.mode[level]][joint] * levels_.displacement[level];
  }

  /// The vibrations of all levels, to return to.
  using Vibrations = std::vector<std::optional<SteadyVibration>>;
  [[nodiscard]] const Vibrations& vibrations() const { return states_; }
  void set_vibrations(const Vibrations& vibrations) { states_ = vibrations; }

  /// Forgets vibrations and offsets of the modes; joints stick.
  void begin_anew();

  /// Drops a level that the joints were not identified from.
  void drop(std::size_t level) { states_[level].reset(); }

  /// Whether a level was sought and not found: the structure does not reach its displacement in its
  /// mode.
  [[nodiscard]] bool missed(std::size_t level) const { return tried_[level] && !states_[level]; }

  /// Whether the response point moves in a mode of the stuck structure.
  [[nodiscard]] bool shows(std::size_t mode) const;

 private:
  void read_stuck();
  [[nodiscard]] std::vector<double> mean_stiffness(std::size_t mode) const;
  void take(const JointedStructure& before, std::vector<double> modes);
  [[nodiscard]] std::optional<SteadyVibration> find(std::size_t level) const;
  void trace(std::size_t mode, const std::vector<std::size_t>& missed);
  [[nodiscard]] std::optional<std::size_t> nearest(std::size_t level) const;
  [[nodiscard]] std::optional<std::size_t> below(std::size_t level) const;
  [[nodiscard]] bool of_mode(std::size_t level, const SteadyVibration& vibration) const;

  const ModalLevels& levels_;
  JointedStructure given_;
  std::vector<double> offsets_;  // of the modes without joints, and of their springs
  std::vector<double> taken_;    // of levels of each mode
  Execution execution_;
  HarmonicBalance balance_;
  std::vector<std::vector<double>> stuck_mode_;   // [mode][mode of the structure]
  std::vector<double> stuck_frequency_;           // of each mode, rad/s
  std::vector<std::vector<double>> stuck_shape_;  // [mode][joint], over the response
  std::vector<std::optional<SteadyVibration>> states_;
  std::vector<bool> tried_;
};

}  // namespace microslip
