// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assembly_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/base/error.hpp"
#include "microslip/identify/smoothing/signed_density.hpp"

namespace microslip {
namespace {

double log_mean_secant(const LevelEvidence& levels) {
  double sum = 0.0;
  for (const double k : levels.levels().secant_stiffness) sum += k;
  return std::log(sum / static_cast<double>(levels.size()));
}

}  // namespace

StiffnessOfAssemblies stiffness_of_assemblies(std::span<const Assembly> assemblies,
                                              std::optional<double> stiffness) {
  if (stiffness) check_stiffness(*stiffness);
  const auto own = std::ranges::count_if(
      assemblies, [](const Assembly& one) { return one.stiffness.has_value(); });
  for (const Assembly& one : assemblies) {
    if (one.stiffness) check_stiffness(*one.stiffness);
    if (own == 0 || one.stiffness) continue;
    throw InputError(fmt::format("stiffness of assembly '{}'", one.name), InputState{"missing"},
                     "must be given for all assemblies or for none", "Complete the column.");
  }
  StiffnessOfAssemblies known;
  known.log_stiffness = Eigen::VectorXd::Zero(std::ssize(assemblies));
  if (own > 0) {
    if (stiffness) {
      throw InputError("stiffness", *stiffness, "is given for each assembly, too",
                       "Leave one of them out.");
    }
    for (Eigen::Index j = 0; j < known.log_stiffness.size(); ++j) {
      known.log_stiffness(j) = std::log(*assemblies[static_cast<std::size_t>(j)].stiffness);
    }
  } else if (!stiffness) {
    throw InputError("stiffness", InputState{"missing"}, "must be given: slip forces are k times A",
                     "Give k of each assembly, or one k for all.");
  } else if (!assemblies.front().levels.levels().secant_stiffness.empty()) {
    known.from = AssemblyStiffness::kSought;
    for (Eigen::Index j = 0; j < known.log_stiffness.size(); ++j) {
      known.log_stiffness(j) = log_mean_secant(assemblies[static_cast<std::size_t>(j)].levels);
    }
  } else {
    known.from = AssemblyStiffness::kCommon;
  }
  const double mean = known.log_stiffness.mean();
  known.log_stiffness.array() -= mean;
  known.middle = known.from == AssemblyStiffness::kGiven ? std::exp(mean) : *stiffness;
  return known;
}

}  // namespace microslip
