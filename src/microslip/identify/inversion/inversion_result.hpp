// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/posterior/density_posterior.hpp"

namespace microslip {

/// One point of the λ path.
struct PathPoint {
  double lambda;        ///< 1
  double edf;           ///< effective degrees of freedom
  double residual;      ///< rms of the weighted residuals
  double gcv;           ///< generalised cross-validation score, with the factor 1.4
  double likelihood;    ///< −2 log restricted likelihood, up to a constant
  double kkt_residual;  ///< of the constrained solution, relative
  double kkt_rounding;  ///< the part of that which may be rounding
};

/// Result of invert(). The density is continuous and linear between the knots, up to the last one.
struct InversionResult {
  std::vector<double> slip_force;  ///< knots, N; from 0 to kA_max, or to the atom
  std::vector<double> density;     ///< φ at the knots, 1/N; ≥ 0
  double area = 0.0;               ///< Φ0 of the density and the atom, 1; ≤ 1

  /// Slip forces at which the density jumps, N, rising: two knots each.
  std::vector<double> edges;
  /// ln λ at the last knot minus that at the first: smoothness changes along the density.
  double smoothing_trend = 0.0;

  std::optional<double> linear_damping;   ///< β, J/m²
  std::optional<double> atom_slip_force;  ///< N; nothing where the data do not reach macro-slip
  double atom_weight = 0.0;               ///< 1

  std::vector<PathPoint> path;  ///< from stiff to flexible
  std::size_t chosen = 0;       ///< index into the path
  double edf = 0.0;             ///< effective degrees of freedom of the solution

  /// Estimated scatter of the levels: relative to D where no standard deviation was given; relative
  /// to that deviation (1 where it is right) where it was.
  double scatter = 0.0;
  bool scatter_is_relative = true;  ///< to D

  /// Scatter of D alone; `scatter` is of D and k_eq together. Degrees of freedom are those that the
  /// rows of each kind leave.
  double dissipation_scatter = 0.0;
  /// Scatter of k_eq alone, relative to its standard deviation; nothing where that was not given.
  /// Below 1 where the standard deviation includes an error common to neighbouring levels, as that
  /// of Reducer does.
  std::optional<double> secant_scatter = {};

  std::vector<double> fitted_dissipation;       ///< D of the result at LevelEvidence::levels(), J
  std::vector<double> fitted_secant_stiffness;  ///< N/m; where k_eq was measured; with the offset
  double secant_offset = 0.0;  ///< weighted mean of k_eq as measured less as D and k give it, N/m
  /// Standard deviation of that mean, N/m: where standard deviations of k_eq were given their
  /// weighted mean, as if the errors were common to all levels; otherwise that of a mean of
  /// independent ones.
  double secant_offset_std = 0.0;

  /// By how much D requires a negative density, in standard deviations (smoothing included): what
  /// the nearest of all joints leaves of D, smoothed as without limits, where it makes the density
  /// negative. Below −3.5 or so the data contradict φ ≥ 0. ≤ 0.
  double lowest_score = 0.0;
  double lowest_at = 0.0;  ///< slip force there, N

  /// Increase of the objective by the limit area ≤ 1, in units of the scatter's variance: above a
  /// dozen or so it contradicts the stiffness k.
  double area_cost = 0.0;
  double unlimited_area = 0.0;  ///< Φ0 without the limit, 1

  /// Solutions beside the result itself: those of the path and of its first pass, of the search for
  /// an atom, and those behind lowest_score and area_cost; and how many did not converge.
  std::size_t inner_solutions = 0;
  std::size_t inner_not_converged = 0;  ///< of them

  Summary summary;  ///< residual: of the optimality conditions, relative

  /// @throws InputError  where its parts do not belong together, or it is empty.
  void check() const;

  /// The posterior of the density: bands are drawn from it.
  DensityPosterior posterior;
};

}  // namespace microslip
