// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/bands.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/identify/inversion/possible_joints.hpp"
#include "microslip/identify/posterior/effective_draws.hpp"
#include "microslip/identify/posterior/quantiles.hpp"

namespace microslip {
namespace {

constexpr std::size_t kFewestSamples = 20;

/// An interval with a value in it.
std::pair<double, double> widened(const std::pair<double, double>& interval, double to) {
  return {std::min(interval.first, to), std::max(interval.second, to)};
}

}  // namespace

void BandOptions::check() const {
  if (samples < kFewestSamples) {
    throw InputError("number of band samples", static_cast<double>(samples), "must be 20 or more",
                     "1000 give smooth bands.");
  }
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw InputError("confidence", confidence, "must be between 0 and 1");
  }
}

DensityBands density_bands(const InversionResult& result, const BandOptions& options) {
  options.check();
  result.check();
  return density_bands(
      result,
      result.posterior.samples(options.seed, options.samples, options.execution, options.progress),
      options.confidence);
}

DensityBands density_bands(const InversionResult& result, std::span<const DensitySample> samples,
                           double confidence) {
  BandOptions{.samples = samples.size(), .confidence = confidence}.check();
  result.check();
  DensityBands bands;
  bands.confidence = confidence;
  bands.samples = samples.size();
  bands.effective_samples = static_cast<double>(samples.size());
  std::vector<double> values(samples.size());
  const auto read_all = [&](const auto& read) {
    std::ranges::transform(samples, values.begin(), read);
    bands.effective_samples =
        std::min(bands.effective_samples, effective_draws(values, result.posterior.chain_length()));
  };
  const auto quantiles_of = [&](const auto& read) {
    read_all(read);
    return quantile_pair(values, confidence);
  };
  // Extremes of D and k_eq pile φ up at single slip forces, wherever these are.
  const auto values_inside = [&](const std::vector<double>& all) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!samples[i].extreme) kept.push_back(all[i]);
    }
    return kept;
  };
  for (std::size_t j = 0; j < result.slip_force.size(); ++j) {
    read_all([j](const DensitySample& sample) { return sample.density[j]; });
    std::vector<double> inside = values_inside(values);
    const auto [lower, upper] = quantile_pair_above_zero(inside, confidence);
    // Where φ ≥ 0 or the smoothing acts, nearly all samples may lie on one side of the estimate.
    bands.lower.push_back(std::min(lower, result.density[j]));
    bands.upper.push_back(std::max(upper, result.density[j]));
  }
  bands.area =
      widened(quantiles_of([](const DensitySample& sample) { return sample.area; }), result.area);
  if (result.posterior.reaches_limits) bands.area = widened(bands.area, least_area(result));
  bands.linear_damping =
      widened(quantiles_of([](const DensitySample& sample) { return sample.linear_damping; }),
              result.linear_damping.value_or(0.0));
  bands.atom_weight =
      widened(quantiles_of([](const DensitySample& sample) { return sample.atom_weight; }),
              result.atom_weight);
  return bands;
}

}  // namespace microslip
