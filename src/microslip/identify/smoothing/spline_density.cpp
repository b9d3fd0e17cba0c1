// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/spline_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// 1/σ² over their mean; empty for equal weights.
std::vector<double> dissipation_weights(const LevelEvidence& levels) {
  if (!levels.dissipation_std_given()) return {};
  std::vector<double> weights = levels.measured().dissipation_std;
  // Relative to the smallest σ, whose square may underflow in J².
  const double smallest = std::ranges::min(weights);
  for (double& weight : weights) weight = (smallest / weight) * (smallest / weight);
  const double mean =
      std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  for (double& weight : weights) weight /= mean;
  return weights;
}

void warn_of_negative(const SignedDensity& density, std::vector<Warning>& warnings) {
  const auto count =
      std::ranges::count_if(density.density, [](double value) { return value < 0.0; });
  if (count == 0) return;
  const auto lowest = std::ranges::min_element(density.density) - density.density.begin();
  const auto place = static_cast<std::size_t>(lowest);
  warnings.push_back({"density_negative",
                      fmt::format("the density is negative at {} of {} levels, down to {:.3g} 1/N "
                                  "at {:.4g} N: too little smoothing, or a normal load that "
                                  "varied. The convex inversion gives an admissible density.",
                                  count, density.density.size(), density.density[place],
                                  density.slip_force[place])});
}

}  // namespace

double SplineDensityResult::density_at(double slip_force) const {
  const double amplitude = slip_force / stiffness;
  const double curvature = fit.spline.second_derivative(amplitude);
  return curvature == 0.0 ? 0.0 : density_from_curvature(curvature, amplitude, stiffness);
}

SplineDensityResult density_by_spline(const LevelEvidence& levels, double stiffness,
                                      const SplineDensityOptions& options) {
  check_stiffness(stiffness);
  SplineDensityResult result;
  result.stiffness = stiffness;
  const std::vector<double> weights = dissipation_weights(levels);
  result.weighted = !weights.empty();
  result.fit = fit_smoothing_spline(levels.measured().amplitude, levels.measured().dissipation,
                                    weights, options.smoothing);
  const auto amplitude = result.fit.spline.knots();
  if (amplitude.size() < 3) {
    throw InputError("number of distinct amplitudes", static_cast<double>(amplitude.size()),
                     "must be at least 3 for a curvature", "Measure more levels");
  }
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    const double curvature = result.fit.spline.knot_second_derivatives()[i];
    result.density.slip_force.push_back(stiffness * amplitude[i]);
    result.density.density.push_back(density_from_curvature(curvature, amplitude[i], stiffness));
  }
  result.warnings = result.fit.warnings;
  warn_of_negative(result.density, result.warnings);
  return result;
}

}  // namespace microslip
