// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/identify/posterior/plain_matrix.hpp"
#include "microslip/observe/common_errors.hpp"

namespace microslip {

/// Likelihood of coefficients x by rows of one kind, which share a scatter s:
///
///     −2 ln p = (‖Rx − z‖² + more)/s² + 2m ln s + constant,
///
/// as few rows as are equivalent to those of the levels, each over its standard deviation of the
/// evidence.
struct PosteriorRows {
  PlainMatrix factor;               ///< R
  std::vector<double> data;         ///< z
  std::vector<double> linear_loss;  ///< w: z + δw is D + δW_lin; empty where W_lin is not known
  double more_square = 0.0;         ///< sum of squares of repeated levels
  double count = 0.0;               ///< m, of independent data
  double least_scatter = 0.0;       ///< of s; 0 where it is free
  double most_scatter = 0.0;        ///< of s; 0 where it is free
};

/// The range of the smoothing parameter λ, in units of a scatter s of 1.
struct PossibleSmoothing {
  double least = 0.0;   ///< > 0
  double most = 0.0;    ///< the same where λ was fixed
  double chosen = 0.0;  ///< where a chain starts
};

/// One density drawn from the posterior; itself a feasible Iwan density.
struct DensitySample {
  std::vector<double> density;  ///< φ at the knots of the posterior, 1/N
  double area = 0.0;            ///< Φ0 of the density and the atom, 1; ≤ 1
  double linear_damping = 0.0;  ///< J/m²
  double atom_weight = 0.0;     ///< 1
  bool extreme = false;  ///< one of the ends of what is possible, see DensityPosterior::goals
};

/// Posterior of a density given levels and prior: numbers alone, which can be kept and drawn from
/// without the levels. For coefficients x ≥ 0 with areaᵀx ≤ 1
///
///     −2 ln p(x, λ, l, s) = Σ of the kinds of rows + 2 ln s each
///                           + Σ_j (λl_j(Lx)_j² − ln λl_j) + 2 ln λ − 2 ln p(l),
///
/// with flat priors of ln λ and of ln s of each kind, and a smoothness that may change along the
/// density: l_j, see theory.md, section 5.
struct DensityPosterior {
  // Meaning of the coefficients.
  std::vector<double> slip_force;      ///< knots of the density, N; rising
  PlainMatrix density;                 ///< gives φ at the knots, 1/N
  std::vector<double> area;            ///< gives Φ0 of the density and the atom, 1
  std::vector<double> linear_damping;  ///< gives β, J/m²
  std::vector<double> atom_weight;     ///< gives the weight of the atom, 1

  // Likelihood of the levels.
  PosteriorRows dissipation;   ///< rows of D
  PosteriorRows secant;        ///< rows of k_eq; none without them
  double scatter = 0.0;        ///< s of all where a chain starts
  CommonErrors common_errors;  ///< that all levels share

  // The prior.
  PlainMatrix penalty;           ///< L
  PossibleSmoothing smoothing;   ///< λ
  double local_deviation = 3.0;  ///< of ln l at each node

  std::vector<double> start;  ///< a good x, where chains start

  /// Every other draw is brought within the limits from outside, see PosteriorChain::projected().
  /// Few levels leave many coefficients that may be 0: no draw of a chain comes near all of these
  /// limits at once, so that the area of each is above one that may be true.
  bool reaches_limits = false;

  /// Linear functions of the coefficients whose largest values count, one per row: of few levels D
  /// between them and k_eq, of which draws of a chain show too little, as the density between and
  /// below few levels is nearly free, and so is what of D is linear damping. Every fourth draw is
  /// one of them in turn: each is more than one in 40 of all draws where there are ten or fewer, so
  /// that bands of 95 % reach it. See possible_coefficients.hpp.
  PlainMatrix goals = {};
  std::vector<double> rises = {};  ///< of −2 ln p above its minimum, one per goal; > 0

  /// Posteriors under other assumptions, each as likely as this, with the same knots: the edges of
  /// the density at other places, or of few levels next to no smoothness. Chains alternate between
  /// them. None where many levels show no edges.
  std::vector<DensityPosterior> others = {};

  /// @throws InputError  where its parts do not belong together, or it is empty.
  void check() const;

  /// Coefficients of the largest value of a goal, to first order about each solution on the way, of
  /// those whose −2 ln p is not above its minimum by more than a rise. The scatter is that where
  /// chains start, and next to no smoothness is assumed: λ is a thousandth of the smallest, of few
  /// levels 1e−8 of it, or the one that was given.
  /// @param gradient  of the goal at coefficients.
  /// @param rise      > 0: 9 for three deviations of a normal distribution without limits.
  [[nodiscard]] std::vector<double> extreme(
      const std::function<std::vector<double>(const std::vector<double>&)>& gradient,
      double rise) const;

  /// Draws in one chain: many where there is one posterior, fewer where chains are to visit
  /// several.
  [[nodiscard]] std::size_t chain_length() const { return others.empty() ? 250 : 25; }

  /// Draws 0 … count − 1 of a seed, with λ, l and s drawn, too, by PosteriorChain: exact but
  /// for the memory of the chain of its start. Draw i is in chain number i/chain_length(), which
  /// starts anew: it is a function of (seed, i) alone, whatever the count and the number of
  /// threads. Neighbours are correlated: DensityBands::effective_samples measures how much.
  ///
  /// Errors that all levels share are drawn for each draw, and the levels do not correct them: the
  /// wrong loss factor adds δW_lin to D; gains scale the density, and a draw with an area above 1
  /// is scaled to 1.
  /// @param seed       of all draws.
  /// @param count      number of draws.
  /// @param execution  of the chains.
  /// @param progress   reports the draws done; may cancel.
  /// @throws InputError  as check(), and where numbers overflow.
  /// @throws Cancelled   when progress returns false.
  [[nodiscard]] std::vector<DensitySample> samples(
      std::uint64_t seed, std::size_t count, const Execution& execution = Execution::threads(),
      const Progress& progress = {}) const;
};

}  // namespace microslip
