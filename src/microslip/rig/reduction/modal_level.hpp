// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/reduced_level.hpp"

/// @file
/// Level of one mode of a structure with several joints, reduced from a steady record.

namespace microslip {

/// The flag of a level in which not all joints are seen.
inline constexpr std::string_view kJointNotSeen = "joint_not_seen";

/// Level of one joint from one record.
struct JointLevel {
  Measured amplitude;         ///< A, half of its displacement peak to peak, m
  Measured dissipation;       ///< D = ∮ F du, J
  Measured secant_stiffness;  ///< k_eq of its loop, N/m: see Reducer
  std::size_t reversals = 2;  ///< of its displacement in a cycle
  /// Share of its force that the accelerometers do not resolve, 0 to 1: 1 where the joint is taken
  /// to stick without a sensor.
  double unseen = 0.0;
};

/// Level from one record: one row of modal_levels.csv.
struct ModalLevel {
  std::string source = {};          ///< of the record
  std::size_t mode = 1;             ///< by the frequency of the structure with stuck joints, from 1
  Measured displacement = {};       ///< first harmonic at the response point, m
  Measured frequency = {};          ///< of phase resonance at this amplitude, Hz
  double drive_frequency = 0.0;     ///< of the cycle, as fitted, Hz
  double force_amplitude = 0.0;     ///< |F_1|, N
  Measured dissipation = {};        ///< W_ext − W_lin, of all joints together, J
  double input_energy = 0.0;        ///< W_ext, J
  double linear_dissipation = 0.0;  ///< W_lin, J
  Measured energy_difference = {};  ///< Σ D_j − (W_ext − W_lin), J: 0 within noise
  double force_distortion = 0.0;    ///< as in ReducedLevel
  double misfit = 0.0;  ///< the worst of the accelerometers against the model's motion, 1
  double cycles = 0.0;  ///< in the record
  std::vector<JointLevel> joints = {};  ///< in the order of the structure
  std::vector<Warning> flags = {};      ///< faults to be checked, each once

  /// Whether one of the flags has this code.
  [[nodiscard]] bool has_flag(std::string_view code) const;
};

}  // namespace microslip
