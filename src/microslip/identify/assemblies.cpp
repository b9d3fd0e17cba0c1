// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/identify/assemblies_check.hpp"
#include "microslip/identify/assemblies_reading.hpp"
#include "microslip/identify/assembly_chain.hpp"
#include "microslip/identify/assembly_start.hpp"

namespace microslip {
namespace {

constexpr std::size_t kFewestDrawsOfAssemblies = 100;
/// Draws of a chain: enough that its start is worth its time.
constexpr std::size_t kAssemblyChain = 250;

/// Draws of all chains, in their order.
std::vector<AssemblyDraw> draw_assemblies(const StartOfAssemblies& found,
                                          const AssembliesOptions& options) {
  std::vector<AssemblyDraw> all(options.draws);
  std::mutex mutex;
  std::size_t done = 0;
  const auto count = [&] {
    if (!options.progress) return;
    const std::lock_guard lock(mutex);
    if (!options.progress(++done, options.draws)) throw Cancelled();
  };
  const std::size_t chains = (options.draws + kAssemblyChain - 1) / kAssemblyChain;
  options.execution.for_each(chains, [&](std::size_t number) {
    AssemblyChain chain(found.model, found.start);
    RandomStream random(options.seed, number);
    chain.settle(random);
    const std::size_t end = std::min(options.draws, (number + 1) * kAssemblyChain);
    for (std::size_t i = number * kAssemblyChain; i < end; ++i) {
      all[i] = chain.next(random);
      count();
    }
  });
  return all;
}

}  // namespace

void AssembliesOptions::check() const {
  if (coefficients < 10) throw InputError("coefficients", coefficients, "must be 10 or more");
  if (draws < kFewestDrawsOfAssemblies) {
    throw InputError("number of draws", static_cast<double>(draws), "must be 100 or more",
                     "1000 give smooth bands.");
  }
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw InputError("confidence", confidence, "must be between 0 and 1");
  }
}

AssembliesResult identify_assemblies(std::span<const Assembly> assemblies,
                                     std::optional<double> stiffness,
                                     const AssembliesOptions& options) {
  Stopwatch watch;
  options.check();
  check_assemblies(assemblies, stiffness);
  const StiffnessOfAssemblies known = stiffness_of_assemblies(assemblies, stiffness);
  // In the order of their names: what is found does not depend on that in which they come.
  std::vector<std::size_t> order(assemblies.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::size_t i) { return assemblies[i].name; });
  std::vector<Assembly> sorted;
  StiffnessOfAssemblies of_sorted = known;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.push_back(assemblies[order[i]]);
    of_sorted.log_stiffness(static_cast<Eigen::Index>(i)) =
        known.log_stiffness(static_cast<Eigen::Index>(order[i]));
  }
  const StartOfAssemblies found = start_of_assemblies(sorted, of_sorted, options.coefficients);

  AssembliesResult result;
  result.summary.timings.push_back(watch.lap("scales and smoothing"));
  const std::vector<AssemblyDraw> draws = draw_assemblies(found, options);
  result.summary.timings.push_back(watch.lap("draws"));
  read_assemblies({sorted, of_sorted, found, draws, options, kAssemblyChain}, result);
  std::vector<AssemblyFit> as_given(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    as_given[order[i]] = std::move(result.assemblies[i]);
  }
  result.assemblies = std::move(as_given);
  result.summary.wall_seconds = watch.seconds();
  return result;
}

}  // namespace microslip
