// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>

#include "microslip/algebra/core.hpp"
#include "microslip/modes/natural_modes.hpp"
#include "microslip/modes/vibrating_system.hpp"

namespace microslip {

/// Static displacements of a structure under loads, and the part that some of its modes lack, as
/// further shapes: fᵀMg = 0 and fᵀKg = 0 between any two of all.
struct StaticAttachment {
  Eigen::VectorXd eigenvalues;  ///< ω² of those shapes, rad²/s², rising; no frequencies of the
                                ///< structure, but above those of the modes
  Eigen::MatrixXd shapes;       ///< of unit modal mass; n × p, p at most one per load
  Eigen::VectorXd compliance;   ///< bᵀx of each load b, m/N: exact
  Eigen::VectorXd in_modes;     ///< the part of it that the modes have, Σ (φ_iᵀb)²/ω_i²
  /// The part that moves without mass, which no shape can have: m/N, one per load.
  Eigen::VectorXd massless;
  Eigen::VectorXd residuals;  ///< |Kx − b| over |b|, 1, one per load
  Eigen::VectorXd rounding;   ///< what rounding of K may make of it, a bound, 1
};

/// Ritz vectors of the residual flexibility [MacNeal 1971; Rubin 1975]: of the static displacement
/// x of each load, (K + B diag(k) Bᵀ) x = b, the part outside of the modes, x − Σ φ_i (φ_iᵀb)/ω_i².
/// With rigid bodies R, of the load that accelerates none, b − M R Rᵀ b. The span of modes and
/// shapes then contains x, so that the compliance between all loads is exact.
/// @param system  the system of the modes.
/// @param modes   one or more.
/// @param loads   b, one per column; n × l.
[[nodiscard]] StaticAttachment attach_statically(const VibratingSystem& system,
                                                 const NaturalModes& modes,
                                                 const Eigen::SparseMatrix<double>& loads);

}  // namespace microslip
