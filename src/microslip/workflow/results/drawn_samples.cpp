// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/drawn_samples.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

#include "microslip/base/interpolation.hpp"
#include "microslip/identify/posterior/quantiles.hpp"

namespace microslip {
namespace {

/// φ of draw i at slip forces: ψ(f*/k)/k², 0 beyond its points.
std::vector<double> density_of_draw(const JointSamples& samples, std::size_t i,
                                    const std::vector<double>& slip_force) {
  const std::size_t points = samples.slip_displacement.size();
  const double k = samples.stiffness[i];
  const auto begin = samples.stiffness_density.begin() + static_cast<std::ptrdiff_t>(i * points);
  const std::vector<double> psi(begin, begin + static_cast<std::ptrdiff_t>(points));
  std::vector<double> density;
  density.reserve(slip_force.size());
  for (const double force : slip_force) {
    const double x =
        std::clamp(force / k, samples.slip_displacement.front(), samples.slip_displacement.back());
    density.push_back(interpolate(samples.slip_displacement, psi, x) / (k * k));
  }
  return density;
}

}  // namespace

SampledDensities sampled_densities(const JointSamples& samples, std::size_t most) {
  const std::size_t count = samples.size();
  const double k = std::accumulate(samples.stiffness.begin(), samples.stiffness.end(), 0.0) /
                   static_cast<double>(count);
  SampledDensities sampled;
  for (const double x : samples.slip_displacement) sampled.found.slip_force.push_back(k * x);
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(density_of_draw(samples, i, sampled.found.slip_force));
  }
  std::vector<double> values(count);
  for (std::size_t at = 0; at < sampled.found.slip_force.size(); ++at) {
    std::ranges::transform(all, values.begin(), [at](const auto& draw) { return draw[at]; });
    sampled.found.density.push_back(std::accumulate(values.begin(), values.end(), 0.0) /
                                    static_cast<double>(count));
    const auto [lower, upper] = quantile_pair_above_zero(values, sampled.found.confidence);
    sampled.found.lower.push_back(lower);
    sampled.found.upper.push_back(upper);
  }
  const std::size_t drawn = std::min(most, count);
  for (std::size_t i = 0; i < drawn; ++i) sampled.drawn.push_back(all[i * count / drawn]);
  if (samples.atom_slip_displacement) {
    sampled.atom_slip_force.push_back(k * *samples.atom_slip_displacement);
  }
  return sampled;
}

}  // namespace microslip
