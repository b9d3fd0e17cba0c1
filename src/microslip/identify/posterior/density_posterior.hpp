// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/observe/common_errors.hpp"

namespace microslip {

/// A matrix, row by row.
struct PlainMatrix {
  std::size_t columns = 0;     ///< numbers in a row
  std::vector<double> values;  ///< rows × columns

  /// How many there are.
  [[nodiscard]] std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
};

/// What levels say of coefficients x by rows of one kind, which share a scatter s:
///
///     −2 ln p = (‖Rx − z‖² + more)/s² + 2m ln s + constant,
///
/// as few rows as say the same as the levels' own, each over its standard deviation as the evidence
/// tells it.
struct PosteriorRows {
  PlainMatrix factor;               ///< R
  std::vector<double> data;         ///< z
  std::vector<double> linear_loss;  ///< w: z + δw is D + δW_lin; empty where W_lin is not known
  double more_square = 0.0;         ///< of what repeated levels differ by
  double count = 0.0;               ///< m, of independent data
  double least_scatter = 0.0;       ///< of s; 0 where it is free
};

/// The smoothing parameters λ that are possible, in units of a scatter s of 1.
struct PossibleSmoothing {
  double least = 0.0;   ///< > 0
  double most = 0.0;    ///< the same where λ was fixed
  double chosen = 0.0;  ///< where a chain starts
};

/// One density drawn from what the data leave possible; itself a feasible Iwan density.
struct DensitySample {
  std::vector<double> density;  ///< φ at the knots of the posterior, 1/N
  double area = 0.0;            ///< Φ0 of the density and the atom, 1; ≤ 1
  double linear_damping = 0.0;  ///< J/m²
  double atom_weight = 0.0;     ///< 1
};

/// What levels and prior leave possible of a density: numbers alone, which can be kept and drawn
/// from without the levels. For coefficients x ≥ 0 with areaᵀx ≤ 1
///
///     −2 ln p(x, λ, l, s) = Σ of the kinds of rows + 2 ln s each
///                           + Σ_j (λl_j(Lx)_j² − ln λl_j) + 2 ln λ − 2 ln p(l),
///
/// with flat priors of ln λ and of ln s of each kind, and a smoothness that may change along the
/// density: l_j, see theory.md, section 5.
struct DensityPosterior {
  // What coefficients mean.
  std::vector<double> slip_force;      ///< knots of the density, N; rising
  PlainMatrix density;                 ///< makes φ at the knots, 1/N
  std::vector<double> area;            ///< makes Φ0 of the density and the atom, 1
  std::vector<double> linear_damping;  ///< makes β, J/m²
  std::vector<double> atom_weight;     ///< makes the weight of the atom, 1

  // What the levels say.
  PosteriorRows dissipation;   ///< rows of D
  PosteriorRows secant;        ///< rows of k_eq; none without them
  double scatter = 0.0;        ///< s of all where a chain starts
  CommonErrors common_errors;  ///< that all levels share

  // The prior.
  PlainMatrix penalty;           ///< L
  PossibleSmoothing smoothing;   ///< λ
  double local_deviation = 3.0;  ///< of ln l at each node

  std::vector<double> start;  ///< a good x, where chains start

  /// The same with the edges of the density elsewhere, each as likely as this; with the same
  /// knots. Chains take turns. None where the density has no edges.
  std::vector<DensityPosterior> elsewhere = {};

  /// @throws InputError  where its parts do not belong together, or it is empty.
  void check() const;

  /// Draws in one chain: many where there is one place of the edges, fewer where chains are to go
  /// to all of them.
  [[nodiscard]] std::size_t chain_length() const { return elsewhere.empty() ? 250 : 25; }

  /// Draws 0 … count − 1 of a seed, with λ, l and s drawn, too, by PosteriorChain: exact but for
  /// what the chain remembers of its start. Draw i stands in chain number i/chain_length(), which
  /// starts anew: it is a function of (seed, i) alone, whatever the count and the number of
  /// threads. Neighbours are alike: DensityBands::effective_samples tells by how much.
  ///
  /// Errors that all levels share are drawn for each draw, and the levels do not correct them: the
  /// wrong loss factor adds δW_lin to D; gains scale what is found, and a draw of more area than 1
  /// is scaled to that.
  /// @param seed       of all draws.
  /// @param count      how many.
  /// @param execution  of the chains.
  /// @param progress   told of the draws done; may cancel.
  /// @throws InputError  as check(), and where numbers overflow.
  /// @throws Cancelled   when progress says so.
  [[nodiscard]] std::vector<DensitySample> samples(
      std::uint64_t seed, std::size_t count, const Execution& execution = Execution::threads(),
      const Progress& progress = {}) const;
};

}  // namespace microslip
