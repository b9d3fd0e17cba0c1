// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/smoothing/natural_spline.hpp"

/// @file
/// The natural cubic smoothing spline: the function g that minimises
///
///     Σ w_i (y_i − g(x_i))² + λ ∫ g″(x)² dx,    λ ≥ 0
///
/// λ → 0 interpolates, λ → ∞ is the weighted straight line. Outside of the data g is straight, and
/// g″ is zero at the first and the last x. Units: x and y in any (here m and J), w in 1/[y]² or
/// dimensionless, λ in [w][x]³.
///
/// With h the mean spacing of the distinct x and w̄ the mean of their weights, λ/(h³w̄) is the
/// scaled λ: a number that no unit changes.
///
/// Solved by Reinsch's equations [C. H. Reinsch, Numer. Math. 10 (1967) 177–183], a pentadiagonal
/// LDLᵀ, and the effective degrees of freedom, the trace of the matrix that turns y into g(x_i),
/// exactly from the central bands of its inverse [M. F. Hutchinson, F. R. de Hoog, Numer. Math. 47
/// (1985) 99–106]: O(n) in time and memory for each λ.

namespace microslip {

/// λ by generalised cross-validation: the smallest GCV(λ) = (RSS/n)/(1 − edf/n)², with n
/// observations, RSS = Σ w(y − g)² and edf the effective degrees of freedom [P. Craven, G. Wahba,
/// Numer. Math. 31 (1979) 377–403], on a grid uniform in ln λ and then by Brent's method around its
/// lowest point.
struct Gcv {
  /// γ of (RSS/n)/(1 − γ edf/n)²; ≥ 1. Plain GCV, γ = 1, takes noise for structure now and then,
  /// above all with few observations; γ = 1.4 seldom does [Y.-J. Kim, C. Gu, J. R. Stat. Soc. B 66
  /// (2004) 337].
  double edf_factor = 1.0;
  int grid_per_decade = 4;  ///< ≥ 1
};

/// This λ.
struct FixedLambda {
  double lambda;  ///< [w][x]³; ≥ 0, ∞ for the straight line
};

/// The λ with these effective degrees of freedom.
struct TargetEdf {
  double edf;  ///< 1; from 2 (straight line) to the number of distinct x (interpolation)
};

/// The smoothing factor of csaps in MATLAB and Octave: p Σ w(y − g)² + (1 − p) ∫ g″²
/// with x expressed in some unit, so λ = (1 − p)/p · unit³. The same p gives another curve in
/// another unit.
struct MatlabP {
  double p;                 ///< 1; in [0, 1]: 0 is the straight line, 1 interpolates
  double x_unit_in_metres;  ///< > 0; 1e−6 where p was found with x in µm; 1 where x is no length
};

/// How λ is chosen.
using Smoothing = std::variant<Gcv, FixedLambda, TargetEdf, MatlabP>;

/// The largest scaled λ, λ/(h³w̄), that Gcv and TargetEdf try. The condition number of the
/// equations is about 16 of it. A larger fixed one is computed with the warning
/// smoothing_too_large, and counts as not converged for more than 1000 points.
inline constexpr double kLargestScaledLambda = 1e12;

/// One point of the GCV curve.
struct GcvPoint {
  double lambda;         ///< [w][x]³
  double scaled_lambda;  ///< λ/(h³w̄), 1
  double edf;            ///< 1
  double gcv;            ///< [w][y]², with the γ of the choice; ∞ where γ edf ≥ n
};

/// Result of fit_smoothing_spline().
struct SmoothingSplineResult {
  NaturalSpline spline;        ///< its knots are the distinct x
  double lambda = 0.0;         ///< [w][x]³
  double scaled_lambda = 0.0;  ///< λ/(h³w̄), 1
  double edf = 0.0;            ///< effective degrees of freedom, 1; in [2, number of knots]
  /// √(RSS/(n − edf)): standard deviation of an observation of weight 1; NaN where n = edf.
  double sigma_hat = 0.0;
  double gcv = 0.0;              ///< GCV(λ) with γ = 1, [w][y]²; NaN where n = edf
  std::vector<double> leverage;  ///< ∂g(x_i)/∂y_i at each knot, 1; its sum is edf
  /// σ̂√(leverage/weight) at each knot, [y]: with 1.96 times it, the band of G. Wahba, J. R. Stat.
  /// Soc. B 45 (1983) 133–150, right on average over the knots, not at each.
  std::vector<double> standard_error;
  std::vector<GcvPoint> gcv_curve;  ///< by rising λ; empty unless λ was chosen by Gcv
  Summary summary;                  ///< of the search for λ
  std::vector<Warning> warnings;    ///< smoothing_too_large, gcv_at_end_of_range
};

/// Fits the smoothing spline. Observations with equal x are merged: their weighted mean with the
/// sum of their weights, which changes neither the curve nor edf; RSS and n count each of them.
/// @param x          at least 2 distinct, 4 for Gcv; any order; finite.
/// @param y          of the length of x; finite.
/// @param weight     w, of the length of x, positive and finite; empty for 1.
/// @param smoothing  how λ is chosen.
/// @throws InputError  naming the value that breaks a rule, its 1-based place included.
[[nodiscard]] SmoothingSplineResult fit_smoothing_spline(std::span<const double> x,
                                                         std::span<const double> y,
                                                         std::span<const double> weight,
                                                         const Smoothing& smoothing = Gcv{});

}  // namespace microslip
