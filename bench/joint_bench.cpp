// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cstddef>
#include <ctime>
#include <vector>

#include "band_limited_path.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"

namespace microslip::bench {
namespace {

constexpr std::size_t kSamples = 1'000'000;
constexpr double kLargest = 2.9e-4;  // m: almost all of the density slips

/// Processor time of the benchmark's loop, reported as `ns_per_sample`.
class SampleClock {
 public:
  explicit SampleClock(benchmark::State& state) : state_(state), begin_(std::clock()) {}

  void report(std::size_t samples) const {
    const double seconds = static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC;
    const double total = static_cast<double>(samples) * static_cast<double>(state_.iterations());
    state_.counters["ns_per_sample"] = 1e9 * seconds / total;
  }

 private:
  benchmark::State& state_;
  std::clock_t begin_;
};

/// The exact memory over a whole path.
void joint_memory_path(benchmark::State& state) {
  const Joint joint = joint_of_100_segments();
  const std::vector<double> x = band_limited_path(kSamples, kLargest);
  std::vector<double> force(x.size());
  const SampleClock clock(state);
  for (auto _ : state) {
    Memory memory(joint);
    memory.march(x, force);
    benchmark::DoNotOptimize(force.data());
  }
  clock.report(x.size());
}
BENCHMARK(joint_memory_path)->Unit(benchmark::kMillisecond);

/// The path by marching elements: approximate, and O(elements) per sample.
void jenkins_network_path(benchmark::State& state) {
  const Joint joint = joint_of_100_segments();
  const auto elements = static_cast<std::size_t>(state.range(0));
  const JenkinsNetwork network = JenkinsNetwork::discretise(joint, elements);
  const std::vector<double> x = band_limited_path(kSamples, kLargest);
  std::vector<double> force(x.size());
  const SampleClock clock(state);
  for (auto _ : state) {
    NetworkMemory memory(network);
    memory.march(x, force);
    benchmark::DoNotOptimize(force.data());
  }
  clock.report(x.size());
  state.counters["slider_updates"] = benchmark::Counter(
      static_cast<double>(elements * x.size() * static_cast<std::size_t>(state.iterations())),
      benchmark::Counter::kIsRate);
}
BENCHMARK(jenkins_network_path)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
