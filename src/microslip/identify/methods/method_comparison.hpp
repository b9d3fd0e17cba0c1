// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "microslip/identify/methods/identification.hpp"
#include "microslip/identify/smoothing/differences.hpp"
#include "microslip/identify/smoothing/spline_density.hpp"
#include "microslip/observe/level_evidence.hpp"

/// @file
/// The same levels by all methods, so that a density can be seen beside the others. [AR14 Fig. 9,
/// 10]

namespace microslip {

/// Result of compare_methods().
struct MethodComparison {
  LevelEvidence evidence;    ///< with the linear damping in D
  double stiffness = 0.0;    ///< k, N/m
  InversionOptions options;  ///< of the inversion
  Identification inversion;  ///< of the levels
  /// The levels minus the linear damping, which the methods below do not model: D − βA², 0 or
  /// more.
  LevelEvidence net_evidence;
  SplineDensityResult spline;     ///< of the net levels
  SignedDensity differences;      ///< of the net levels
  std::vector<Warning> warnings;  ///< by the method that the options name
};

/// Inversion, spline and differences of levels.
/// @param evidence        kFewestLevels different amplitudes or more.
/// @param stiffness       k, N/m.
/// @param options         of the method whose warnings are wanted; bands are not computed.
/// @param linear_damping  β of D = … + βA² that was identified, J/m²; nothing where none was.
/// @throws InputError  as identify().
[[nodiscard]] MethodComparison compare_methods(const LevelEvidence& evidence, double stiffness,
                                               const IdentificationOptions& options,
                                               std::optional<double> linear_damping = {});

/// The inversion with λ times a factor.
/// @param methods  of the levels.
/// @param factor   > 0.
/// @throws InputError  where they contain no inversion, or the factor breaks its rule.
[[nodiscard]] Identification inversion_with(const MethodComparison& methods, double factor);

/// The spline with λ times a factor.
/// @param methods  of the levels.
/// @param factor   > 0.
[[nodiscard]] Identification spline_with(const MethodComparison& methods, double factor);

}  // namespace microslip
