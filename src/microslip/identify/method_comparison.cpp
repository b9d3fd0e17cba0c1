// SPDX-License-Identifier: MIT
#include "microslip/identify/method_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/identify/check_result.hpp"

namespace microslip {
namespace {

/// The other methods know no linear damping. At the lowest levels it may be all that there is.
Levels without_damping(Levels levels, double beta) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double damping = beta * std::pow(levels.amplitude[i], 2);
    levels.dissipation[i] = std::max(levels.dissipation[i] - damping, 0.0);
  }
  return levels;
}

Identification invert_levels(const Levels& levels, const InversionOptions& options) {
  IdentificationOptions all;
  all.inversion = options;
  return identify(levels, all);
}

/// What the method of the options says of these levels.
std::vector<Warning> warnings_of(const Levels& levels, IdentificationOptions options,
                                 const Identification& inversion) {
  if (options.method == IdentificationMethod::kInversion && !options.fit) return inversion.warnings;
  options.bands.reset();
  return identify(levels, options).warnings;
}

}  // namespace

MethodComparison compare_methods(const Levels& levels, const IdentificationOptions& options,
                                 std::optional<double> linear_damping) {
  Levels merged = sort_and_merge(levels).levels;
  IdentificationOptions all = options;
  if (linear_damping) all.inversion.linear_damping = true;
  const double stiffness = all.inversion.stiffness;
  Identification inversion = invert_levels(merged, all.inversion);
  Levels net = without_damping(merged, linear_damping.value_or(0.0));
  SplineDensityResult spline = density_by_spline(net, stiffness, {all.spline_smoothing});
  SignedDensity differences = density_by_differences(net, stiffness);
  std::vector<Warning> warnings = warnings_of(merged, all, inversion);
  return {.levels = std::move(merged),
          .options = all.inversion,
          .inversion = std::move(inversion),
          .net_levels = std::move(net),
          .spline = std::move(spline),
          .differences = std::move(differences),
          .warnings = std::move(warnings)};
}

Identification inversion_with(const MethodComparison& methods, double factor) {
  if (!methods.inversion.inversion) {
    throw InputError("methods", "without inversion", "must be what compare_methods() returned");
  }
  const InversionResult& result = *methods.inversion.inversion;
  check_result(result);
  InversionOptions options = methods.options;
  options.lambda = factor * result.path[result.chosen].lambda;
  return invert_levels(methods.levels, options);
}

Identification spline_with(const MethodComparison& methods, double factor) {
  IdentificationOptions options;
  options.method = IdentificationMethod::kSpline;
  options.inversion.stiffness = methods.options.stiffness;
  options.spline_smoothing = FixedLambda{methods.spline.fit.lambda * factor};
  return identify(methods.net_levels, options);
}

}  // namespace microslip
