// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "microslip/algebra/core.hpp"

namespace microslip {

/// Modes of K φ = ω² M φ.
struct ModalPairs {
  Eigen::VectorXd eigenvalues;  ///< ω², rad²/s², of the highest θ = 1/(ω² − σ) first
  Eigen::MatrixXd shapes;       ///< φ, one per column, φᵀMφ = 1
};

/// All modes that have mass of a small pencil, each ω² with its own digits: from the factors
/// K − σM = LLᵀ and M = GGᵀ, the right singular vectors v of GᵀL⁻ᵀ by rotations of its columns
/// (one-sided Jacobi), φ = √θ⁻¹ L⁻ᵀv, and ω² = φᵀKφ. Scaling of rows, as by springs of 1e16 N/m
/// that fix some, leaves the others as they are, where solvers of a symmetric standard problem
/// lose ε times the largest ω² of all. [Demmel & Veselić]
/// @param stiffness  K, symmetric but for rounding, which is taken out.
/// @param mass       M, likewise; without a negative eigenvalue.
/// @param shift      σ, below all ω².
/// @throws InputError  where K − σM has no Cholesky factor.
[[nodiscard]] ModalPairs definite_pairs(const Eigen::MatrixXd& stiffness,
                                        const Eigen::MatrixXd& mass, double shift);

/// Reports negative eigenvalues of a stiffness matrix.
/// @param negative  their number; none where it is not known.
/// @throws InputError  always.
[[noreturn]] void refuse_negative_stiffness(std::optional<std::size_t> negative);

}  // namespace microslip
