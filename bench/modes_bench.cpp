// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>

#include "brick_block.hpp"
#include "microslip/modes/structure_modes.hpp"

/// @file Modes of matrices of finite elements.

namespace microslip::bench {
namespace {

/// The most memory that the process had so far, MiB.
double peak_memory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // which Linux gives in KiB
}

/// 30 modes of 10⁵ degrees of freedom: of a plate of 3 bricks through its thickness, then of a
/// compact block of 17, whose factor fills far more. The memory before is that of the matrices and
/// of their assembly; both are the peaks of the process so far, so that the plate comes first.
void modes_100k(benchmark::State& state) {
  const auto through = static_cast<std::size_t>(state.range(0));
  const auto bricks = through == 3 ? std::array<std::size_t, 3>{130, 63, 3}
                                   : std::array<std::size_t, 3>{60, 30, through};
  const MeshedStructure block = brick_block(bricks, {0.01, 0.01, 0.01});
  state.counters["memory_before_MiB"] = peak_memory();
  std::optional<StructureModes> found;
  for (auto _ : state) {
    found = compute_structure_modes(block, {.count = 30, .attached_points = {"tip"}});
  }
  if (!found->summary.converged()) state.SkipWithError(found->summary.reason.c_str());
  state.counters["peak_memory_MiB"] = peak_memory();
  state.counters["degrees_of_freedom"] = static_cast<double>(found->degrees_of_freedom);
  state.counters["first_Hz"] =
      found->model.modes().front().angular_frequency / (2.0 * std::numbers::pi);
  state.counters["residual"] = found->summary.residual;
}
BENCHMARK(modes_100k)->ArgName("through")->Arg(3)->Arg(17)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace microslip::bench
