// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"
#include "support/rigs.hpp"

namespace {

using namespace microslip;

constexpr std::size_t kPoints = 51200;
constexpr double kRate = 51200.0;    // Hz
constexpr double kFrequency = 55.3;  // Hz

/// First and third harmonic as in a level of 14 m/s², with noise.
Channel channel(const std::string& name, const Dimension& dimension, std::complex<double> first,
                double noise, std::uint64_t stream) {
  RandomStream random(1, stream);
  Channel channel{name, dimension, {}, {}, {}};
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * kFrequency * static_cast<double>(i) / kRate;
    const auto wave = [&](double n) { return (first * std::polar(1.0, n * angle)).real(); };
    channel.values.push_back(wave(1.0) + 0.03 * wave(3.0) + noise * random.normal());
  }
  return channel;
}

Recording record(std::uint64_t seed) {
  Recording recording{"record", {}, {}, {}};
  recording.axis.step = 1.0 / kRate;
  const std::complex<double> phase = std::polar(1.0, -1.57);
  recording.channels = {channel("force", kForce, 1.39, 2e-3, 5 * seed),
                        channel("acc1", kAcceleration, 14.0 * phase, 5e-3, 5 * seed + 1),
                        channel("acc2", kAcceleration, 70.5 * phase, 5e-3, 5 * seed + 2),
                        channel("acc3", kAcceleration, 42.6 * phase, 5e-3, 5 * seed + 3),
                        channel("ldv", kLength, -1.03e-4 * phase, 2e-8, 5 * seed + 4)};
  return recording;
}

/// 90 records of one second with five channels, from the samples to the levels.
void reduce_90_records(benchmark::State& state) {
  constexpr std::size_t kFiles = 90;
  constexpr std::size_t kDistinct = 6;
  std::vector<Recording> records;
  for (std::uint64_t i = 0; i < kDistinct; ++i) records.push_back(record(i));
  const Reducer reducer(testing::reference_rig());
  for (auto _ : state) {
    const ReductionBatch batch = reduce_batch(reducer, kFiles, [&](std::size_t i) {
      return std::vector<Recording>{records[i % kDistinct]};
    });
    benchmark::DoNotOptimize(batch.levels.data());
  }
}
BENCHMARK(reduce_90_records)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
