// SPDX-License-Identifier: MIT
#include "microslip/identify/bands.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/identify/quantiles.hpp"

namespace microslip {
namespace {

constexpr std::size_t kFewestSamples = 20;

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
  result.posterior.check();
  std::vector<DensitySample> samples(options.samples);
  options.execution.for_each(
      options.samples,
      [&](std::size_t i) { samples[i] = result.posterior.sample(options.seed, i); },
      options.progress);

  DensityBands bands;
  bands.confidence = options.confidence;
  bands.samples = options.samples;
  bands.not_converged =
      static_cast<std::size_t>(std::ranges::count(samples, false, &DensitySample::converged));
  std::vector<double> values(samples.size());
  const auto quantiles_of = [&](const auto& read) {
    std::ranges::transform(samples, values.begin(), read);
    return quantile_pair(values, options.confidence);
  };
  for (std::size_t j = 0; j < result.slip_force.size(); ++j) {
    const auto [lower, upper] =
        quantiles_of([j](const DensitySample& sample) { return sample.density[j]; });
    // Where φ ≥ 0 or the smoothing acts, nearly all samples may lie on one side of the estimate.
    bands.lower.push_back(std::min(lower, result.density[j]));
    bands.upper.push_back(std::max(upper, result.density[j]));
  }
  bands.area = quantiles_of([](const DensitySample& sample) { return sample.area; });
  bands.linear_damping =
      quantiles_of([](const DensitySample& sample) { return sample.linear_damping; });
  bands.atom_weight = quantiles_of([](const DensitySample& sample) { return sample.atom_weight; });
  return bands;
}

}  // namespace microslip
