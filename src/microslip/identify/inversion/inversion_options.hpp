// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "microslip/identify/smoothing/smoothing_rule.hpp"

namespace microslip {

/// How invert() solves.
struct InversionOptions {
  /// How the smoothing parameter λ is chosen, unless `lambda` is given.
  SmoothingRule rule = SmoothingRule::kGcv;

  /// λ in the scaled variables of the inversion, as the path reports it; > 0.
  std::optional<double> lambda = {};

  /// Adds βA² with β ≥ 0 to D: linear (material, air, shaker) damping that was not subtracted.
  /// Where the density continues below the lowest amplitude the two can hardly be distinguished.
  bool linear_damping = false;

  /// Adds an atom where the density ends: the slip force at which the joint passes into macro-slip,
  /// sought within the range of the data.
  bool atom = false;

  /// Lets the density jump and bend where the levels make it very likely that a population of
  /// sliders ends there, and its smoothness have a trend; of 40 levels or more.
  bool edges = true;

  /// Coefficients of the density; ≥ 10. More than the default cost time only.
  int coefficients = 56;

  /// Points of the λ path; ≥ 5.
  std::size_t path_points = 50;

  /// @throws InputError  naming the option that breaks a rule.
  void check() const;
};

/// The least number of levels that invert() takes.
inline constexpr std::size_t kFewestLevels = 4;

}  // namespace microslip
