// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/calibrate/linearisation.hpp"
#include "microslip/identify/inversion/edge_search.hpp"

/// @file
/// Edges of the density of one joint among several. Internal to calibrate.

namespace microslip {

/// Levels linear about the joints found so far, with edges in the density of one of them. With
/// λ and τ as settle() has them for the edges,
///
///     −2 ln p = Σ_kinds (‖Ax − b‖²/τ² + 2m ln τ) + Σ_j λ_j‖L_j x‖²
///               + ln det(H + diag p) − Σ_j ln det⁺(λ_j L_jᵀL_j) − Σ_j Σ_ranges 2 ln p_r,
///
/// all coefficients integrated out. The unpenalised part, a straight line on each of the ranges
/// between edges, is given the size of the solution as its prior deviation 1/√p_r, as in
/// InversionModel::evidence(). Infinite where the levels leave too little freedom.
class JointEdges final : public EdgedModel {
 public:
  /// @param evidence  with the levels. @param levels  linear. Both must outlive this.
  /// @param unknowns  of all joints; the edges of the others stay.
  /// @param joint     among them.
  /// @param bounds    of τ.
  JointEdges(const CalibrationEvidence& evidence, const LinearisedLevels& levels,
             AllUnknowns unknowns, std::size_t joint, const ScatterBounds& bounds);

  [[nodiscard]] EdgedFit fit(std::vector<BasisEdge> edges, double trend, const EdgedFit& start,
                             bool coarse) override;
  [[nodiscard]] SolutionBends bends(const EdgedFit& fit) override;

  /// A fit with the weights of all joints.
  [[nodiscard]] static EdgedFit start(const EvidenceWeights& weights);
  /// The fit with the edges of the unknowns.
  [[nodiscard]] EdgedFit present(const EvidenceWeights& weights);

  /// All edges that are worth their price, and whose place is known well enough to distinguish them
  /// from a bend.
  [[nodiscard]] EdgedFit find(const EdgedFit& start);

  /// The edges of the unknowns that still are.
  [[nodiscard]] EdgedFit kept(const EvidenceWeights& weights);

  /// −2 ln p with ψ = 0 on some of the ranges between the edges of the unknowns.
  [[nodiscard]] double evidence_without(const std::vector<bool>& empty,
                                        const EvidenceWeights& start) const;

  [[nodiscard]] EdgeSearch search();

  /// Slip displacements of edges, m.
  [[nodiscard]] std::vector<double> slip_displacements(const std::vector<BasisEdge>& edges) const;

 private:
  [[nodiscard]] EdgedFit distinguished_from_bends(EdgedFit found);
  [[nodiscard]] AllUnknowns with(const std::vector<BasisEdge>& edges) const;

  const CalibrationEvidence& evidence_;
  const LinearisedLevels& levels_;
  AllUnknowns unknowns_;
  std::size_t joint_;
  ScatterBounds bounds_;
};

}  // namespace microslip
