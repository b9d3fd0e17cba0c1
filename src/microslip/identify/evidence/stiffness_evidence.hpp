// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/level_evidence.hpp"

/// @file
/// Measured stiffness compared with a joint that was identified from dissipation: secant
/// stiffnesses as they are, and resonance frequencies by their change, for which no model of the
/// structure is needed. With the share p(A) of the joint in the stiffness energy of a mode
///
///     d ln f = ½ p d ln k_eq,   0 ≤ p ≤ 1                  (Rayleigh's quotient is stationary)
///
/// so that from one amplitude to a higher one a mode neither rises nor falls by more than √k_eq. p
/// is 1 for an equivalent joint between a drive point and the ground.

namespace microslip {

/// k_eq of the levels against that of a joint.
struct SecantEvidence {
  /// Mean of k_eq as measured minus that of the joint, weighted by 1/σ², N/m.
  double offset = 0.0;
  /// Standard deviation of that mean, N/m: the weighted mean of the σ given, as if the errors were
  /// common to all levels; where none was given that of a mean of independent errors as large as
  /// the measured scatter, of 0.1 % of k at least.
  double offset_std = 0.0;
  /// Residual without the offset, rms over σ, 1; nothing where σ was not given.
  std::optional<double> scatter;
};

/// A change of the frequency between two levels.
struct FrequencyChange {
  double from = 0.0;            ///< amplitude, m
  double to = 0.0;              ///< amplitude, m; not below `from`
  double from_frequency = 0.0;  ///< Hz
  double to_frequency = 0.0;    ///< Hz
  double change = 0.0;          ///< of the frequency, relative, 1
  double explained = 0.0;       ///< the most that a possible joint explains of it, 1
  double beyond = 0.0;          ///< the part of it that is not explained, 1
  double limit = 0.0;        ///< the most of that by the given deviations, or steps of a drive, 1
  bool significant = false;  ///< whether `beyond` exceeds it
};

/// Frequencies of the levels against k_eq of a joint.
struct FrequencyEvidence {
  FrequencyChange rise;  ///< the largest: a joint explains none
  FrequencyChange fall;  ///< the one that exceeds the joint's softening most
  double share = 0.0;    ///< p in [0, 1] that leaves the least `uncertainty`, 1
  /// Half the range that the measured frequencies have about f0 (k_eq(A)/k_eq(A_1))^(p/2) with the
  /// best f0 and p, Hz. No structure with this joint explains them better: predictions are
  /// uncertain by that at least.
  double uncertainty = 0.0;
  /// The largest |f − f̂|, Hz, with f̂ through the lowest level and p = 1.
  double equivalent_joint_error = 0.0;
};

/// Evidence of the levels on the stiffness; empty where they have no such column.
struct StiffnessEvidence {
  std::optional<SecantEvidence> secant;  ///< where k_eq was measured
  std::optional<FrequencyEvidence>
      frequency;  ///< where frequencies of two levels or more are given
};

/// The joint that softens most from one amplitude to a higher one, m, of those that the levels
/// leave possible.
using SoftestJoint = std::function<Joint(double from, double to)>;

/// @param levels   with their errors.
/// @param joint    identified from them.
/// @param softest  with it a fall of the frequency is significant only where none of these joints
///                 explains it; without it `joint` is taken for certain.
[[nodiscard]] StiffnessEvidence stiffness_evidence(const LevelEvidence& levels, const Joint& joint,
                                                   const SoftestJoint& softest = {});

/// Warnings of the evidence:
///   * `secant_inconsistent`     the mean of k_eq deviates from that of the joint by more than 1 %
///                               of k, and by more than three standard deviations;
///   * `secant_misfit`           k_eq changes differently from that of the joint: by more than
///                               twice the standard deviations given;
///   * `frequency_rises`         by more than 0.3 % between two levels, or more than 0.1 % and
///                               three standard deviations of each where they are given;
///   * `softening_unexplained`   it falls by as much beyond all of the joint's softening.
[[nodiscard]] std::vector<Warning> diagnose(const StiffnessEvidence& evidence, const Joint& joint);

/// `secant_inconsistent` alone.
/// @param secant     measured k_eq against the joint.
/// @param stiffness  k of the joint, N/m.
/// @param remainder  elastic remainder of the joint, 1.
[[nodiscard]] std::optional<Warning> diagnose_offset(const SecantEvidence& secant, double stiffness,
                                                     double remainder);

}  // namespace microslip
