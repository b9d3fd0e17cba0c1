// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/identify/bands.hpp"
#include "microslip/identify/inversion.hpp"
#include "microslip/identify/levels.hpp"
#include "microslip/identify/parametric.hpp"
#include "microslip/identify/spline_density.hpp"
#include "microslip/identify/stiffness_evidence.hpp"
#include "microslip/joint/joint.hpp"

namespace microslip {

/// How a density is found from levels.
enum class IdentificationMethod {
  kInversion,    ///< invert(): the one to use
  kSpline,       ///< density_by_spline(), [AR14 Fig. 9]
  kDifferences,  ///< density_by_differences(), a baseline
};

/// "inversion", "spline", "differences".
[[nodiscard]] std::string_view to_string(IdentificationMethod method);

/// What identify() does.
struct IdentificationOptions {
  IdentificationMethod method = IdentificationMethod::kInversion;  ///< how the density is found
  InversionOptions inversion;                           ///< its stiffness is that of all methods
  Smoothing spline_smoothing = Gcv{.edf_factor = 1.4};  ///< of kSpline: see SplineDensityOptions
  std::optional<ParametricModel> fit;  ///< a parametric model in place of the density
  std::optional<BandOptions> bands;    ///< with kInversion and without `fit` only
};

/// A joint from levels, and what its user must know of it.
struct Identification {
  /// @param used   the method.
  /// @param found  its joint.
  Identification(IdentificationMethod used, Joint found) : method(used), joint(std::move(found)) {}

  IdentificationMethod method;  ///< that was used
  Joint joint;  ///< the identified density, or the parametric model that was asked for
  double covered_from = 0.0;  ///< kA_min, N: below it the levels tell two moments of φ only
  double covered_to = 0.0;    ///< kA_max, N: above it they tell nothing

  /// The density of `joint` at points for plots, with its band where there is one.
  std::vector<double> slip_force;  ///< N
  std::vector<double> density;     ///< 1/N
  std::vector<double> lower;       ///< 1/N; empty without a band
  std::vector<double> upper;       ///< 1/N; as many

  std::optional<double> linear_damping;  ///< β, J/m²

  // What the methods said, where they ran.
  std::optional<InversionResult> inversion;    ///< of kInversion
  std::optional<SplineDensityResult> spline;   ///< of kSpline
  std::optional<SignedDensity> differences;    ///< of kDifferences
  std::optional<ParametricResult> parametric;  ///< of the parametric model that was asked for
  std::optional<DensityBands> bands;           ///< where they were asked for

  /// Measured k_eq and frequencies held against `joint`.
  StiffnessEvidence stiffness = {};

  std::vector<Warning> warnings;  ///< of the levels, the method and the stiffness, see diagnose()
  Summary summary;                ///< of the method
};

/// Levels to joint by the chosen method, judged: see diagnose() in diagnostics.hpp and
/// stiffness_evidence.hpp for the warnings.
/// Methods whose density may be negative give a joint with max(φ, 0), scaled to an area of 1 where
/// it is above; both are said in a warning.
/// @throws InputError  where an option or a level breaks a rule.
/// @throws Cancelled   as density_bands().
[[nodiscard]] Identification identify(const Levels& levels, const IdentificationOptions& options);

}  // namespace microslip
