// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "microslip/algebra/core.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/modes/vibrating_system.hpp"
#include "microslip/structure/meshed_structure.hpp"

namespace microslip {

/// Which modes are wanted; the one or the other.
struct ModeRange {
  std::optional<std::size_t> count = {};         ///< so many, from the lowest; 1 to kMostModes
  std::optional<double> highest_frequency = {};  ///< all up to this, Hz; > 0
};

/// The lowest modes of a system: (K + B diag(k) Bᵀ) φ_i = ω_i² M φ_i, φ_iᵀ M φ_j = δ_ij.
struct NaturalModes {
  Eigen::VectorXd eigenvalues;   ///< ω_i², rad²/s², rising; 0 of rigid bodies
  Eigen::MatrixXd shapes;        ///< φ_i, its largest component positive; n × m
  std::size_t rigid_bodies = 0;  ///< number of rigid-body modes, the first
  /// What rounding of K can make of ω² of a rigid body, a bound, rad²/s²; 0 without rigid bodies.
  /// Nothing distinguishes a soft spring from none below it.
  double rounding = 0.0;
  /// Below this ω², rad²/s², modes are not distinguished from rigid bodies, and there are such: a
  /// rigid body whose φᵀKφ is above 1/16 of the bound, as that of soft springs beside stiff ones
  /// may be, or a mode within the rounding that K may have. 0 where nothing is in doubt.
  double doubtful = 0.0;
  Eigen::VectorXd residuals;  ///< |(K − ω²M)φ| over |Kφ| + ω²|Mφ|, 1; of rigid bodies 0
  /// Factor of the system, at a σ < 0 that is small against ω² of the first mode that strains, if
  /// one was found.
  std::shared_ptr<const ShiftedFactor> factor;
  Summary summary = {};  ///< its residual is the largest; doubtful where modes may be missing
};

/// Shift-invert Lanczos from below all eigenvalues (Spectra), then Rayleigh–Ritz of the shapes
/// after inverse iteration. The Sturm count at a frequency above them shows whether a mode is
/// missed; missed ones, of multiple eigenvalues, are sought orthogonal to those found. Small
/// systems are solved densely (definite_pairs()). A mode is that of a rigid body where its strain
/// energy is rounding of the entries of K,
///
///     φᵀKφ ≤ (16 ε + ε_K) |φ|ᵀ|K||φ|
///
/// with ε of a double and ε_K = VibratingSystem::stiffness_rounding; where it is negative, with
/// the possible_rounding as well.
/// @param system    whose M has no negative eigenvalue.
/// @param range     with more modes than the system has, all of them.
/// @param progress  called with the solutions done of their number; may stop the search.
/// @throws InputError  where K has a negative eigenvalue beyond possible rounding, or no mode is
///     in the range.
/// @throws Cancelled
[[nodiscard]] NaturalModes find_natural_modes(const VibratingSystem& system, const ModeRange& range,
                                              const Progress& progress = {});

/// Negates the columns whose largest component is negative: a shape has no sign of its own.
void turn_positive(Eigen::MatrixXd& shapes);

}  // namespace microslip
