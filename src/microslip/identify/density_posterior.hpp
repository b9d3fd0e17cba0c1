// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/observe/common_errors.hpp"

namespace microslip {

/// A matrix, row by row.
struct PlainMatrix {
  std::size_t columns = 0;     ///< numbers in a row
  std::vector<double> values;  ///< rows × columns

  /// How many there are.
  [[nodiscard]] std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
};

/// A smoothing parameter that the levels leave possible.
struct PossibleSmoothing {
  double lambda = 0.0;               ///< > 0, in the scaled variables of the inversion
  double weight = 0.0;               ///< likelihood, up to a factor; ≥ 0
  std::vector<double> coefficients;  ///< of the best density with it: where a search may start
};

/// One density drawn from what the data leave possible; itself a feasible Iwan density.
struct DensitySample {
  std::vector<double> density;  ///< φ at the knots of the posterior, 1/N
  double area = 0.0;            ///< Φ0 of the density and the atom, 1; ≤ 1
  double linear_damping = 0.0;  ///< J/m²
  double atom_weight = 0.0;     ///< 1
  bool converged = false;       ///< whether its optimality conditions hold
};

/// What levels and prior leave possible of a density: numbers alone, which can be kept and drawn
/// from without the levels. With coefficients x ≥ 0, areaᵀx ≤ 1,
///
///     −2 ln p(x) = ‖W(Kx − d)‖²/s² + λ‖Lx‖²/s² + constant.
///
/// W is a row's standard deviation as the evidence tells it, s the scatter that was found.
struct DensityPosterior {
  // What coefficients mean.
  std::vector<double> slip_force;      ///< knots of the density, N; rising
  PlainMatrix density;                 ///< makes φ at the knots, 1/N
  std::vector<double> area;            ///< makes Φ0 of the density and the atom, 1
  std::vector<double> linear_damping;  ///< makes β, J/m²
  std::vector<double> atom_weight;     ///< makes the weight of the atom, 1

  // What the levels say.
  PlainMatrix information;           ///< KᵀW²K
  std::vector<double> data;          ///< KᵀW²d
  PlainMatrix dissipation_factor;    ///< R with RᵀR the share of the rows of D in it
  PlainMatrix secant_factor;         ///< that of the rows of k_eq; none without them
  std::vector<double> linear_loss;   ///< KᵀW²d of W_lin; empty where it is not known
  double dissipation_scatter = 0.0;  ///< s of the rows of D, 1
  double secant_scatter = 0.0;       ///< s of those of k_eq, 1; at least that of the σ given
  double scatter = 0.0;              ///< s of all
  double degrees_of_freedom = 0.0;   ///< ν of s², which is scaled inverse χ²
  CommonErrors common_errors;        ///< that all levels share

  // The prior.
  PlainMatrix penalty;                       ///< L
  std::vector<PossibleSmoothing> smoothing;  ///< λ; one where it was fixed

  /// @throws InputError  where its parts do not belong together, or it is empty.
  void check() const;

  /// Sample `index` of a seed: the constrained problem solved again with data and prior perturbed
  /// (randomise-then-optimise [Bardsley & Fox 2012; Everink, Dong & Andersen 2023]),
  ///
  ///     minimise ½‖W(Kx − d) − sε‖² + ½‖√l Lx − c s δ‖²  subject to the same limits,
  ///     ε, δ ~ N(0, 1),
  ///
  /// where s² is drawn from its scaled inverse χ², apart for D and for k_eq, and λ by its weight.
  /// With l = λ and c = 1 and without limits these would be exact samples. That posterior knows
  /// nothing of the bias of the smoothing: at peaks and kinks it is too narrow, and for a density
  /// much smoother than its prior too wide. So the samples are smoothed less, but perturbed less
  /// too: l = λ/8 with c = ½. In simulation with 90 levels of 1 % scatter the nominal 95 % band
  /// then covers 0.96 to 0.99 of the range on average, on smooth, peaked and kinked densities
  /// (tests/identify); with 20 levels of 3 % 0.91 and more. Beside a step of the density it covers
  /// less. A wrong loss factor adds δW_lin to D before the problem is solved; gains scale the
  /// sample. A function of (seed, index) alone.
  /// @param seed   of all samples.
  /// @param index  of this one.
  /// @throws InputError  as check().
  [[nodiscard]] DensitySample sample(std::uint64_t seed, std::size_t index) const;
};

}  // namespace microslip
