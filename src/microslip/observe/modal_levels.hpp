// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace microslip {

/// Measurements of one joint of a structure at its modal levels, one entry per level; NaN where not
/// measured. Vectors may be empty: never measured.
struct JointLevels {
  std::string name = {};                     ///< of the joint in the model
  std::vector<double> amplitude = {};        ///< half range of its displacement, m
  std::vector<double> amplitude_std = {};    ///< standard deviation of it, m
  std::vector<double> dissipation = {};      ///< D of this joint alone, J per cycle
  std::vector<double> dissipation_std = {};  ///< standard deviation of it, J
};

/// Levels of the resonances of a structure with joints: the loss per cycle of a mode at rising
/// amplitude, and its frequency there. One entry per level; NaN where something was not measured.
/// `mode` and `displacement` are whole; each other vector is as long or empty (never measured).
struct ModalLevels {
  std::vector<std::size_t> mode = {};          ///< by frequency with all joints stuck, from 0
  std::vector<double> displacement = {};       ///< first harmonic at the response point, m; > 0
  std::vector<double> displacement_std = {};   ///< its standard deviation, m; ≥ 0
  std::vector<double> frequency = {};          ///< of the resonance at this level, Hz; > 0
  std::vector<double> frequency_std = {};      ///< its standard deviation, Hz; ≥ 0
  std::vector<double> dissipation = {};        ///< of all joints together, J per cycle; ≥ 0
  std::vector<double> dissipation_std = {};    ///< its standard deviation, J; ≥ 0
  std::vector<double> damping_ratio = {};      ///< ζ of structure and joints, 1; ≥ 0
  std::vector<double> damping_ratio_std = {};  ///< its standard deviation, 1; ≥ 0
  std::vector<JointLevels> joints = {};        ///< those with sensors or an observer of their own
  /// Number of the measurement session, any; empty: one session. The frequency offset of a mode may
  /// differ between sessions.
  std::vector<std::size_t> session = {};

  /// The number of levels.
  [[nodiscard]] std::size_t size() const { return mode.size(); }

  /// Whether two levels are of one mode and measured in one session.
  [[nodiscard]] bool same_offset(std::size_t i, std::size_t j) const {
    return mode[i] == mode[j] && (session.empty() || session[i] == session[j]);
  }

  /// Entry i of a vector that may be empty; NaN where it is.
  [[nodiscard]] static double value(const std::vector<double>& values, std::size_t i) {
    return i < values.size() ? values[i] : std::numeric_limits<double>::quiet_NaN();
  }
};

/// Appends the levels of another file; columns that one of them lacks are NaN there, and the
/// session is 0.
void append(const ModalLevels& more, ModalLevels& levels);

/// The levels with the given indices, from 0.
[[nodiscard]] ModalLevels some_levels(const ModalLevels& levels,
                                      std::span<const std::size_t> which);

/// The number of levels without repetitions: those of one mode at one displacement are one.
[[nodiscard]] std::size_t distinct_levels(const ModalLevels& levels);

/// Checks the rules of ModalLevels, and that each level has a loss: D of all joints, D of one, or
/// ζ.
/// @throws InputError  naming the level (from 1) and the value.
void check_modal_levels(const ModalLevels& levels);

}  // namespace microslip
