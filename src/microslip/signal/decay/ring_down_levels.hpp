// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/signal/decay/ring_down.hpp"

namespace microslip {

/// Properties of the mode and its joint for levels_of().
struct RingDownLevelsOptions {
  /// m, kg, above 0: the mode's mass at the sensor, 1/φ² with its mass-normalised shape φ there.
  double modal_mass = 0.0;
  /// Joint displacement over displacement at the sensor, 1; not 0. The mode's shape is taken as
  /// fixed.
  double joint_ratio = 1.0;
  /// η of the linear part, 1, ≥ 0; its loss πηmω₀²A² per cycle is subtracted.
  double loss_factor = 0.0;
  /// ω₀/2π, Hz: the mode's frequency with the joint stuck. Without it the highest frequency of the
  /// decay counts as such where η needs one.
  std::optional<double> stick_frequency = {};
  /// k of the stuck joint, N/m. With it, and the stick frequency, the secant stiffness is given.
  std::optional<double> joint_stiffness = {};
};

/// Levels of a joint from a decay, one entry per level by falling amplitude. Levels are half a
/// window apart, so that they are nearly independent.
struct RingDownLevels {
  std::vector<double> amplitude;        ///< of the joint's displacement, |joint_ratio|·A, m
  std::vector<double> amplitude_std;    ///< its standard deviation, m
  std::vector<double> dissipation;      ///< D = 2πζω²mA² − πηmω₀²A², J per cycle
  std::vector<double> dissipation_std;  ///< its standard deviation, J
  /// k + m(ω² − ω₀²)/joint_ratio², N/m, of first order in the change; empty without k.
  std::vector<double> secant_stiffness;
  std::vector<double> secant_stiffness_std;  ///< its standard deviation, N/m
  std::vector<double> time;                  ///< s
  std::vector<double> frequency;             ///< Hz
  std::vector<double> frequency_std;         ///< its standard deviation, Hz
  std::vector<double> damping_ratio;         ///< of the mode, linear part included, 1
  std::vector<double> damping_ratio_std;     ///< its standard deviation, 1
  std::vector<std::string> flags;            ///< as of RingDown, with those of adjacent windows
  std::vector<Warning> warnings;             ///< what was left out, and why
};

/// Levels of the joint from the decay of a mode.
/// @throws InputError  for an option out of range, or k without the stick frequency.
[[nodiscard]] RingDownLevels levels_of(const RingDown& decay, const RingDownLevelsOptions& options);

/// Levels without a modal mass: no dissipation and no secant stiffness.
/// @param decay        of a mode.
/// @param joint_ratio  as in RingDownLevelsOptions.
/// @throws InputError  where it is 0 or not finite.
[[nodiscard]] RingDownLevels damping_levels_of(const RingDown& decay, double joint_ratio = 1.0);

}  // namespace microslip
