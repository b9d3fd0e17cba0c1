// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/identify/posterior/density_posterior.hpp"

/// @file
/// The levels to measure next: linear Gaussian design by draws of a posterior.

namespace microslip {

/// Candidate levels and their measurements as predicted by draws of the density.
struct FurtherLevels {
  std::vector<double> amplitude = {};        ///< A of the candidates, m; > 0, rising
  PlainMatrix dissipation = {};              ///< D of each draw, J: draws × candidates
  std::vector<double> dissipation_std = {};  ///< σ_D of one level at each of them, J; > 0

  /// k_eq of each draw minus its weighted mean over the existing levels, N/m; empty where k_eq is
  /// not measured.
  PlainMatrix secant_stiffness = {};
  /// σ_k of one level, N/m; > 0; one per candidate.
  std::vector<double> secant_stiffness_std = {};
  double secant_offset_std = 0.0;  ///< of that mean, which all further levels share, N/m
};

/// Quantities whose uncertainty is to be reduced: numbers t_j with a weight each.
struct DesignTarget {
  PlainMatrix draws = {};           ///< of each draw: draws × numbers
  std::vector<double> weight = {};  ///< w_j of each number; ≥ 0
};

/// One of the amplitudes to measure.
struct DesignedLevel {
  std::size_t candidate = 0;  ///< its number among the candidates
  std::size_t repeats = 0;    ///< number of levels there
  double before = 0.0;        ///< S expected with all levels of a higher rank
  double after = 0.0;         ///< S with these as well
  /// S with this amplitude repeated without end: the limit of further repeats.
  double endless = 0.0;
};

/// Levels to measure, and the mean standard deviation S = Σ_j w_j σ(t_j) that is expected then.
struct LevelDesign {
  double now = 0.0;                        ///< S of the draws
  std::vector<DesignedLevel> levels = {};  ///< by rank: each lowers S most, of those below it
  double after = 0.0;                      ///< S with all of them
  double one_more = 0.0;                   ///< S with one more, where that lowers it most
  std::size_t exchanges = 0;               ///< levels of the greedy choice replaced by better ones
};

/// Seeks the n levels after which S is least. With G the covariance of the draws, of the
/// candidates' D and k_eq and of t, n levels at rows r, repeats allowed, leave
///
///     G − G_·r (G_rr + diag σ²)⁻¹ G_r·,
///
/// as of a Gaussian; the limits φ ≥ 0 and Φ0 ≤ 1 are in G, which is that of draws within
/// them. What the levels will add on smoothness and scatter is not predicted. The levels are chosen
/// one by one, each the best beside those before; then each is exchanged for the best in its place
/// until none is better [Fedorov].
/// @param further  the candidates; at least one.
/// @param target   of as many draws, two or more.
/// @param count    n; 1 to kMostDesigned.
/// @throws InputError  where lengths differ, or a number breaks its rule.
[[nodiscard]] LevelDesign design_levels(const FurtherLevels& further, const DesignTarget& target,
                                        std::size_t count);

/// The most levels that design_levels() seeks.
inline constexpr std::size_t kMostDesigned = 1000;

}  // namespace microslip
