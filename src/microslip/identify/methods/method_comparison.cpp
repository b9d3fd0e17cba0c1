// SPDX-License-Identifier: MIT
#include "microslip/identify/methods/method_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// The other methods do not model linear damping. At the lowest levels it may be all of D.
Levels without_damping(Levels levels, double beta) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double damping = beta * std::pow(levels.amplitude[i], 2);
    levels.dissipation[i] = std::max(levels.dissipation[i] - damping, 0.0);
  }
  return levels;
}

Identification invert_levels(const LevelEvidence& levels, double stiffness,
                             const InversionOptions& options) {
  return identify(levels, stiffness, {.inversion = options});
}

/// Warnings of the method of the options for these levels.
std::vector<Warning> warnings_of(const LevelEvidence& levels, double stiffness,
                                 IdentificationOptions options, const Identification& inversion) {
  if (options.method == IdentificationMethod::kInversion && !options.fit) return inversion.warnings;
  options.bands.reset();
  return identify(levels, stiffness, options).warnings;
}

}  // namespace

MethodComparison compare_methods(const LevelEvidence& evidence, double stiffness,
                                 const IdentificationOptions& options,
                                 std::optional<double> linear_damping) {
  IdentificationOptions all = options;
  if (linear_damping) all.inversion.linear_damping = true;
  Identification inversion = invert_levels(evidence, stiffness, all.inversion);
  LevelEvidence net(without_damping(evidence.levels(), linear_damping.value_or(0.0)));
  SplineDensityResult spline = density_by_spline(net, stiffness, all.spline);
  SignedDensity differences = density_by_differences(net, stiffness);
  std::vector<Warning> warnings = warnings_of(evidence, stiffness, all, inversion);
  return {.evidence = evidence,
          .stiffness = stiffness,
          .options = all.inversion,
          .inversion = std::move(inversion),
          .net_evidence = std::move(net),
          .spline = std::move(spline),
          .differences = std::move(differences),
          .warnings = std::move(warnings)};
}

Identification inversion_with(const MethodComparison& methods, double factor) {
  const InversionResult* result = methods.inversion.inversion();
  if (!result) {
    throw InputError("methods", "without inversion", "must be what compare_methods() returned");
  }
  result->check();
  InversionOptions options = methods.options;
  options.lambda = factor * result->path[result->chosen].lambda;
  return invert_levels(methods.evidence, methods.stiffness, options);
}

Identification spline_with(const MethodComparison& methods, double factor) {
  return identify(methods.net_evidence, methods.stiffness,
                  {.method = IdentificationMethod::kSpline,
                   .spline = {FixedLambda{methods.spline.fit.lambda * factor}}});
}

}  // namespace microslip
