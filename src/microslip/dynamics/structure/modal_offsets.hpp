// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

/// @file
/// Offsets of the frequencies of modes without joints, from frequencies of the structure with its
/// joints.

namespace microslip {

/// Offset of the frequency of a vibration with the joints.
struct StructureOffset {
  std::size_t mode = 0;  ///< by frequency with all joints stuck, from 0
  double offset = 0.0;   ///< δ, as a logarithm, 1
  /// Stiffness that the joints have in it, N/m, one per joint; k of each where it is stuck.
  std::vector<double> joint_stiffness = {};
};

/// Offsets of the modes without joints.
struct ModalOffsets {
  std::vector<double> offset = {};  ///< ε_i, as a logarithm, 1; one per mode, 0 of static ones
  /// ∂ε_i/∂δ_m of each mode and each measured vibration, 1: [mode][vibration].
  std::vector<std::vector<double>> by_measured = {};
  /// ∂ε_i/∂ε⁰_i, 1; in 0…1: the share of each mode that the measured vibrations do not determine.
  std::vector<double> left = {};
};

/// ω of a vibration by the stiffness that the joints have in it, rad/s; its offset is not used. The
/// mode is the most similar to that of the stuck structure, as frequencies may cross.
[[nodiscard]] double secant_frequency(const JointedStructure& structure,
                                      const StructureOffset& measured);

/// The share Σ_i S_mi of the stiffness of a vibration that is of its modes, with the springs that
/// these have across the joints, 1.
[[nodiscard]] double share_of_modes(const JointedStructure& structure,
                                    const StructureOffset& measured);

/// Shares of the stiffness of a vibration: ln Ω_m follows ln ω_i by S_mi and ln k_s,j by −P_mj/2.
struct VibrationShares {
  std::vector<double> modes = {};    ///< S_mi, 1; 0 of static modes
  std::vector<double> springs = {};  ///< P_mj = k_s,j (ψ_jᵀq_m)²/Ω_m², 1

  [[nodiscard]] double of_modes() const;  ///< Σ_i S_mi, 1
  /// Σ_i S_mi − Σ_j P_mj: the share that is not of joints, 1.
  [[nodiscard]] double without_joints() const;
};

/// As secant_frequency(), of the stiffness that the modes and each joint have in a vibration.
[[nodiscard]] VibrationShares vibration_shares(const JointedStructure& structure,
                                               const StructureOffset& measured);

/// The ε that are nearest to ε⁰, by least squares, of those that give the measured vibrations, with
/// unchanged joints:
///
///     ln Ω_m(ε) − ln Ω_m(0) = δ_m,   S_mi = ∂ln Ω_m/∂ln ω_i = ω_i² q_mi²/Ω_m²
///
/// with Ω² the eigenvalues of diag(ω_i²) − Σ k_s ψψᵀ + Σ κ ψψᵀ, κ the stiffness of each joint with
/// its compliance in series, and q_m their vectors of length 1: Rayleigh's quotient. By Newton's
/// method, S⁺ the pseudo-inverse: ε = ε⁰ + S⁺(δ − Sε⁰) to first order.
/// @param structure  with the joints found. @param measured  the measured vibrations, none twice.
/// @param others     ε⁰ of each mode, 1.
/// @param springs    of with_modal_offsets(): where there are some, static modes have ε⁰, else 0.
/// @throws InputError  where no ε gives them, or the structure has none without its joints.
[[nodiscard]] ModalOffsets modal_offsets(const JointedStructure& structure,
                                         std::span<const StructureOffset> measured, double others,
                                         std::span<const double> springs = {});

/// The structure with each ω_i times e^ε_i and each k_s,j times e^(2μ_j): where all ε and μ are
/// the same, the stiffness of all that is not a joint is e^(2ε) times as large.
/// @param structure  before. @param offset  ε, one per mode.
/// @param springs    μ, one per joint; empty: 0 of all.
/// @throws InputError  as JointedStructure.
[[nodiscard]] JointedStructure with_modal_offsets(const JointedStructure& structure,
                                                  std::span<const double> offset,
                                                  std::span<const double> springs = {});

}  // namespace microslip
