// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"

namespace microslip::bench {
namespace {

constexpr double kRate = 51200.0;  // 1/s
constexpr std::size_t kPoints = 51200;
constexpr double kFrequency = 55.637;  // Hz
constexpr int kChannels = 5;

/// One second of five channels with ten harmonics and noise.
std::vector<std::vector<double>> record(const Axis& axis) {
  std::vector<std::vector<double>> signals;
  for (int j = 0; j < kChannels; ++j) {
    FourierSeries series;
    series.omega = 2.0 * std::acos(-1.0) * kFrequency;
    for (int n = 1; n <= 10; ++n)
      series.harmonic.push_back(std::polar(std::pow(0.3, n), 1.0 * n + j));
    signals.push_back(values(series, axis, kPoints));
    RandomStream random(2014, static_cast<std::uint64_t>(j));
    for (double& value : signals.back()) value += 1e-3 * random.normal();
  }
  return signals;
}

/// A record as the reduction of a test fits it, all included.
void fit_record(benchmark::State& state, std::optional<double> guess) {
  Axis axis;
  axis.step = 1.0 / kRate;
  const std::vector<std::vector<double>> signals = record(axis);
  const std::vector<std::span<const double>> spans(signals.begin(), signals.end());
  FourierFitOptions options;
  options.order = 10;
  options.frequency_guess = guess;
  for (auto _ : state) {
    const FourierFit fit = fit_fourier(axis, spans, options);
    if (!fit.summary.converged()) state.SkipWithError("not converged");
    benchmark::DoNotOptimize(fit.omega);
  }
}
BENCHMARK_CAPTURE(fit_record, no_guess, std::nullopt)
    ->Name("fourier_fit/51200x10")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit_record, guess, 1.01 * kFrequency)
    ->Name("fourier_fit_guess/51200x10")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
