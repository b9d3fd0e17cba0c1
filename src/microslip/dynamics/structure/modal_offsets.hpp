// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

/// @file
/// Modes without joints whose frequencies are off, from frequencies of the structure with its
/// joints.

namespace microslip {

/// What the frequency of a vibration with the joints is off by.
struct StructureOffset {
  std::size_t mode = 0;  ///< by frequency with all joints stuck, from 0
  double offset = 0.0;   ///< δ, as a logarithm, 1
  /// Stiffness that the joints have in it, N/m, one a joint; k of each where it is stuck.
  std::vector<double> joint_stiffness = {};
};

/// What the modes without joints are off by.
struct ModalOffsets {
  std::vector<double> offset = {};  ///< ε_i, as a logarithm, 1; one a mode, 0 of static ones
  /// ∂ε_i/∂δ_m of each mode and each vibration that is told, 1: [mode][told].
  std::vector<std::vector<double>> by_told = {};
  /// ∂ε_i/∂ε⁰_i, 1; in 0…1: how far each mode is left to what those that are not told are off by.
  std::vector<double> left = {};
};

/// ω of a vibration by the stiffness that the joints have in it, rad/s; its offset plays no part.
/// It is the one that looks most like that of the stuck structure, as frequencies may cross.
[[nodiscard]] double secant_frequency(const JointedStructure& structure,
                                      const StructureOffset& told);

/// The share Σ_i S_mi of the stiffness of a vibration that is not of its joints, 1.
[[nodiscard]] double share_of_modes(const JointedStructure& structure, const StructureOffset& told);

/// The ε that are nearest to ε⁰, by least squares, of those that move the vibrations told as they
/// are measured, the joints as they are:
///
///     ln Ω_m(ε) − ln Ω_m(0) = δ_m,   S_mi = ∂ln Ω_m/∂ln ω_i = ω_i² q_mi²/Ω_m²
///
/// with Ω² the eigenvalues of diag(ω_i²) − Σ k_s ψψᵀ + Σ κ ψψᵀ, κ the stiffness of each joint with
/// what lies in series, and q_m their vectors of length 1: Rayleigh's quotient. By Newton's method,
/// S⁺ the pseudo-inverse: ε = ε⁰ + S⁺(δ − Sε⁰) to first order.
/// @param structure  with the joints found. @param told  no vibration twice.
/// @param others     ε⁰ of each mode, 1.
/// @throws InputError  where no ε moves them so, or the structure has none without its joints.
[[nodiscard]] ModalOffsets modal_offsets(const JointedStructure& structure,
                                         std::span<const StructureOffset> told, double others);

/// The structure with each ω_i times e^ε_i.
/// @param structure  before. @param offset  ε, one a mode.
/// @throws InputError  as JointedStructure.
[[nodiscard]] JointedStructure with_modal_offsets(const JointedStructure& structure,
                                                  std::span<const double> offset);

}  // namespace microslip
