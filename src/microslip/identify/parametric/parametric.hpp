// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/parametric/parametric_model.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// Options of fit_parametric().
struct ParametricOptions {
  /// Fit also βl ≥ 0 of a linear damping βl·A² that is still in the measured D.
  bool linear_damping = false;
  /// Starts of the search, the best of a coarse grid; ≥ 1.
  int starts = 6;
  /// Evaluations of the residuals and of their derivatives that one start may take; ≥ 1.
  int max_evaluations = 400;

  /// @throws InputError  naming the option that breaks a rule.
  void check() const;
};

/// One parameter of a fit.
struct FittedParameter {
  std::string name;  ///< as in the files of joints: "macroslip_force", "chi", …; "linear_damping"
  std::string unit;  ///< "N", "1", …
  double value = 0.0;  ///< in `unit`
  /// Standard deviation; 0 where at_bound fixes the value, ∞ where the levels do not determine
  /// it.
  double standard_error = 0.0;
  bool at_bound = false;  ///< the best value lies at the end of the admissible range
};

/// Result of fit_parametric().
struct ParametricResult {
  ParametricModel model;                    ///< fitted model
  Joint joint;                              ///< the best joint of the model
  double linear_damping = 0.0;              ///< βl, J/m²; 0 unless fitted
  std::vector<FittedParameter> parameters;  ///< those of the model in the order above, then βl
  /// Covariance of the parameters, row-major, n × n: of first order, with those at a bound fixed
  /// there.
  std::vector<double> covariance;

  double chi_squared = 0.0;    ///< Σ (residual/σ)², with the σ above
  int degrees_of_freedom = 0;  ///< rows − parameters that are not at a bound
  /// σ_D/D, 1, and σ_k, N/m, estimated from the misfit; empty where the deviations were given.
  std::optional<double> dissipation_noise;
  std::optional<double> secant_noise;  ///< N/m
  double misfit = 0.0;  ///< √(mean (D_model/D − 1)²) over the levels with D > 0, 1
  /// Akaike's and the Bayesian information criterion of a normal likelihood, counting every
  /// parameter and every estimated noise: of the models fitted to the same levels the lowest is to
  /// be preferred.
  double aic = 0.0;
  double bic = 0.0;  ///< the Bayesian one

  Summary summary;                ///< of the best start
  std::vector<Warning> warnings;  ///< see fit_parametric()
};

/// The parameters of a model by weighted least squares: the smallest sum of squares of
///
///     (D_model(A_i) + βl A_i² − D_i)/σ_i             and, where k_eq was measured,
///     (k_eq,model(A_i) − k_eq,i)/σ_k,i
///
/// σ is that of LevelEvidence at the fit, with a scatter that is estimated from the misfit where
/// no standard deviations were given; where σ depends on the fit, both are found alternately.
///
/// Method: each parameter moves inside of its range by a smooth one-to-one transformation
/// (logarithm or logit), in which MINPACK's Levenberg–Marquardt [J. J. Moré, Lect. Notes Math.
/// 630 (1978) 105–116] runs from several starts; the same again with each combination of
/// parameters fixed at an admissible bound (chi = 0, beta = 0, weight = 1, to = f_d, βl = 0). The
/// smallest sum wins, and of equal ones that with more parameters at a bound. So a bound is hit
/// exactly and never only approached.
///
/// Warnings: parameter_at_bound; macroslip_not_reached (four_parameter: with all levels below
/// macro-slip F_S and beta cannot be distinguished); not_identifiable; noise_not_given;
/// systematic_misfit (the residuals of neighbouring levels are correlated, see
/// serial_correlation()).
/// @param evidence   more distinct amplitudes than parameters.
/// @param stiffness  k, N/m; positive and finite.
/// @param model      whose parameters are sought.
/// @param options    the fitted terms, and the limits of the search.
/// @throws InputError  naming the value that breaks a rule.
[[nodiscard]] ParametricResult fit_parametric(const LevelEvidence& evidence, double stiffness,
                                              ParametricModel model,
                                              const ParametricOptions& options = {});

}  // namespace microslip
