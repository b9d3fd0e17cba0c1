// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace microslip {

/// How standard errors are found from the residuals.
enum class ResidualModel {
  /// The record is cut in blocks of about ∛(number of cycles) cycles, shorter ones where these are
  /// fewer than 16, and the scatter of the contribution of each block to a coefficient is taken:
  /// correct also where the residuals are correlated over less than a block (controller noise, slow
  /// changes of amplitude), or between signals. With fewer than 8 blocks: as kWhite.
  kBlocks,
  /// Independent residuals of equal variance RSS/(points − unknowns).
  kWhite,
};

/// Options of fit_fourier().
struct FourierFitOptions {
  /// H; 1 … 100. Reduced, with the warning order_reduced, where H·f is above 0.45 of the (mean)
  /// sampling rate or there are fewer than two points an unknown.
  int order = 10;
  /// Approximate fundamental, Hz, > 0. None: found from the spectrum.
  std::optional<double> frequency_guess = {};
  /// How far from the guess the fundamental may lie, relative; in (0, 0.3].
  double guess_tolerance = 0.03;
  /// Whether, without a guess, the strongest line may belong to a longer period. False: it is the
  /// fundamental, as in a test at resonance, where hum must not make a period out of two lines.
  bool seek_longer_period = true;
  /// K, degree of the slow trend; 0 (mean alone) … 4. 1, a straight drift, by default.
  int trend_degree = 1;
  /// False: the fundamental is the guess, which must be given, and only the rest is fitted.
  bool fit_frequency = true;
  ResidualModel residuals = ResidualModel::kBlocks;  ///< for the standard errors
  /// The share of its variance (about mean and trend) that the series must explain in one signal
  /// at least, or the fit counts as not converged: no periodic content; in [0, 1).
  double least_explained = 0.5;
  int max_iterations = 50;  ///< > 0
};

}  // namespace microslip
