// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/identify/inversion.hpp"

namespace microslip {

/// How density_bands() samples.
struct BandOptions {
  std::size_t samples = 1000;  ///< ≥ 20
  double confidence = 0.95;    ///< nominal coverage, in (0, 1)
  std::uint64_t seed = 1;      ///< of all samples

  /// Standard deviations of gain errors that all levels share, relative, ≥ 0: of D (force and
  /// velocity sensors together) and of A (displacement sensor). 0 where the calibration is not in
  /// question.
  double dissipation_gain_std = 0.0;
  double amplitude_gain_std = 0.0;  ///< of A

  /// Standard deviation of the loss factor of the structure, relative, ≥ 0: with a share δ too much
  /// of it, all levels have δW_lin too little D. Above 0 it needs Levels::linear_dissipation.
  double loss_factor_std = 0.0;

  Progress progress = {};                      ///< told of the samples done of all; may cancel
  Execution execution = Execution::threads();  ///< of the samples
};

/// Pointwise band of a density: at each slip force by itself. Its lower edge as a whole is no
/// joint, nor is its upper edge: no sample follows either, and their areas may lie far outside of
/// `area`.
struct DensityBands {
  double confidence = 0.0;                   ///< nominal coverage, 1
  std::vector<double> lower;                 ///< 1/N; one a knot of the result
  std::vector<double> upper;                 ///< 1/N
  std::pair<double, double> area;            ///< of Φ0, 1
  std::pair<double, double> linear_damping;  ///< of β, J/m²; zeros where it was not fitted
  std::pair<double, double> atom_weight;     ///< 1; zeros where there is none
  std::size_t samples = 0;                   ///< that were drawn
  std::size_t not_converged = 0;             ///< of them; they count as they are
};

/// One density drawn from what the data leave possible; itself a feasible Iwan density.
struct DensitySample {
  std::vector<double> density;  ///< φ at the knots of the result, 1/N
  double area = 0.0;            ///< Φ0 of the density and the atom, 1; ≤ 1
  double linear_damping = 0.0;  ///< J/m²
  double atom_weight = 0.0;     ///< 1
  bool converged = false;       ///< whether its optimality conditions hold
};

/// Sample `index` of a seed: the constrained problem solved again with data and prior perturbed
/// (randomise-then-optimise [Bardsley & Fox 2012; Everink, Dong & Andersen 2023]),
///
///     minimise ½‖W(Kθ − D) − sε‖² + ½‖√l Lθ − c s δ‖²  subject to the same limits,
///     ε, δ ~ N(0, 1),
///
/// where s² is drawn from its scaled inverse χ², apart for D and for k_eq; for k_eq it is at least
/// that of the given standard deviations, which may hold errors common to all levels. λ, unless it
/// was fixed, is drawn from its likelihood over the path. With l = λ and c = 1 and without limits
/// these would be exact samples of the posterior of θ. That posterior knows nothing of the bias of
/// the smoothing: at peaks and kinks it is too narrow, and for a density much smoother than its
/// prior too wide. So the samples are smoothed less, but perturbed less too: l = λ/8 with c = ½. In
/// simulation with 90 levels of 1 % scatter the nominal 95 % band then covers 0.96 to 0.99 of the
/// range on average, on smooth, peaked and kinked densities (tests/identify); with 20 levels of 3 %
/// 0.91 and more. Beside a step of the density it covers less. A wrong loss factor perturbs D by
/// δW_lin, δ ~ N(0, loss_factor_std²), before the problem is solved. A function of (seed, index)
/// alone.
/// @throws InputError  where a standard deviation breaks its rule, loss_factor_std lacks the
///                     linear_dissipation of the levels, or the result is none of invert().
[[nodiscard]] DensitySample sample_density(const InversionResult& result,
                                           const BandOptions& options, std::size_t index);

/// Pointwise quantiles of samples 0 … samples − 1, widened to the estimate where they do not hold
/// it; on all processors; the same on any number of them.
/// @throws InputError  where an option breaks its rule, or as sample_density().
/// @throws Cancelled   when progress says so.
[[nodiscard]] DensityBands density_bands(const InversionResult& result, const BandOptions& options);

}  // namespace microslip
