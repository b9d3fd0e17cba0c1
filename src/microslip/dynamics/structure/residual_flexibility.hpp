// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/dynamics/structure/further_modes.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// Static compliance of the modes that a model leaves out, at some of its points and across some of
/// its joints:
///
///     R_pq = (static compliance of the structure)_pq − Σ_i φ_i(p) φ_i(q)/ω_i²,   m/N
///
/// over the elastic modes that the model has, of the structure of those modes: with the springs
/// that they contain across joints. [MacNeal 1971]
struct ResidualFlexibility {
  std::vector<std::string> points = {};  ///< names of points of the model
  std::vector<std::string> joints = {};  ///< names of joints of it
  /// R by rows, those of the points first; symmetric, without a negative eigenvalue.
  std::vector<double> compliance = {};
};

/// Modes that represent a residual flexibility: with S = diag(√R_pp), of the eigenvectors v of
/// S⁻¹RS⁻¹ with eigenvalues λ > 0, φ_a = ω_a √λ Sv, so that all of them, at the frequency ω_a, have
/// R. ω_a is ten times the highest ω of the structure's modes, beyond most harmonics of a balance:
/// their compliance is larger by (ω/ω_a)² in a vibration of ω, 1/100 at the highest. Their loss
/// factor is that of the highest mode.
/// @param structure  that they are added to, by with_further_modes().
/// @param residual   of it.
/// @throws InputError  for names that the structure does not have, or that occur twice; for another
///                     number of entries than a square has; entries that are not finite or not
///                     those across the diagonal; an R_pp below 0, or of 0 beside others in its
///                     row; a negative λ; where joints with springs K = diag(k) in the modes would
///                     yield more than the springs, K^½(Σ ψ_i ψ_iᵀ/ω_i² + R)K^½ with an eigenvalue
///                     above 1.001 and above those of the modes alone; a structure without an
///                     elastic mode.
[[nodiscard]] std::vector<FurtherMode> static_modes(const JointedStructure& structure,
                                                    const ResidualFlexibility& residual);

/// Ten times the highest ω of the vibrations of a structure, rad/s: the frequency of modes that
/// represent static compliance.
/// @throws InputError  without an elastic mode.
[[nodiscard]] double static_mode_frequency(const JointedStructure& structure);

/// A static mode for which the motion of its places is to be given: at static_mode_frequency(),
/// with the loss factor of the highest mode, all places at rest.
/// @throws InputError  as static_mode_frequency().
[[nodiscard]] FurtherMode static_mode_at_rest(const JointedStructure& structure);

}  // namespace microslip
