// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assemblies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/identify/assemblies/assemblies_reading.hpp"
#include "microslip/identify/assemblies/assembly_chain.hpp"
#include "microslip/identify/assemblies/assembly_start.hpp"
#include "microslip/identify/assemblies/assembly_stiffness.hpp"

namespace microslip {
namespace {

/// Draws of a chain: enough to amortise its start.
constexpr std::size_t kAssemblyChain = 250;

void check_names(std::span<const Assembly> assemblies) {
  std::set<std::string> names;
  for (const Assembly& one : assemblies) {
    if (one.name.empty())
      throw InputError("name of an assembly", InputState{"empty"}, "must be given");
    if (!names.insert(one.name).second) {
      throw InputError("name of an assembly", fmt::format("'{}' twice", one.name), "must be unique",
                       "Name assemblies, or files, differently.");
    }
  }
}

/// Checks that all assemblies have a column, or none.
template <typename Has>
void check_alike(std::span<const Assembly> assemblies, std::string_view what, const Has& has) {
  const bool first = has(assemblies.front().levels);
  for (const Assembly& one : assemblies) {
    if (has(one.levels) == first) continue;
    throw InputError(fmt::format("{} of assembly '{}'", what, one.name),
                     InputState{first ? "missing" : "given"},
                     fmt::format("must be given for all assemblies or for none; that of '{}' is{}",
                                 assemblies.front().name, first ? "" : " not"),
                     "Leave the column out, or complete it.");
  }
}

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

void check_assemblies(std::span<const Assembly> assemblies, std::optional<double> stiffness) {
  if (assemblies.size() < kFewestAssemblies) {
    throw InputError(
        "number of assemblies", static_cast<double>(assemblies.size()),
        fmt::format("must be {} or more: fewer hardly determine how much the next one may differ",
                    kFewestAssemblies),
        "Measure more assemblies, or identify the levels together as those of one joint.");
  }
  check_names(assemblies);
  check_alike(assemblies, "dissipation_std",
              [](const LevelEvidence& levels) { return levels.dissipation_std_given(); });
  check_alike(assemblies, "secant_stiffness", [](const LevelEvidence& levels) {
    return !levels.levels().secant_stiffness.empty();
  });
  check_alike(assemblies, "secant_stiffness_std",
              [](const LevelEvidence& levels) { return levels.secant_std_given(); });
  for (const Assembly& one : assemblies) {
    const CommonErrors& common = one.levels.common_errors();
    if (common.dissipation_gain_std == 0.0 && common.amplitude_gain_std == 0.0 &&
        common.loss_factor_std == 0.0) {
      continue;
    }
    throw InputError("errors that all levels share", InputState{"given"},
                     "are not sampled for several assemblies", "Leave them out.");
  }
  (void)stiffness_of_assemblies(assemblies, stiffness);
}

AssembliesResult identify_assemblies(std::span<const Assembly> assemblies,
                                     std::optional<double> stiffness,
                                     const AssembliesOptions& options) {
  Stopwatch watch;
  options.check();
  check_assemblies(assemblies, stiffness);
  const StiffnessOfAssemblies known = stiffness_of_assemblies(assemblies, stiffness);
  // In the order of their names: the result does not depend on the order given.
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
