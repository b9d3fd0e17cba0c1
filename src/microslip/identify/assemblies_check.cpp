// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/identify/signed_density.hpp"

namespace microslip {
namespace {

void check_names(std::span<const Assembly> assemblies) {
  std::set<std::string> names;
  for (const Assembly& one : assemblies) {
    if (one.name.empty())
      throw InputError("name of an assembly", InputState{"empty"}, "must be given");
    if (!names.insert(one.name).second) {
      throw InputError("name of an assembly", fmt::format("'{}' twice", one.name),
                       "must be its own", "Name assemblies, or files, differently.");
    }
  }
}

/// What all must have, or none.
template <typename Has>
void check_alike(std::span<const Assembly> assemblies, std::string_view what, const Has& has) {
  const bool first = has(assemblies.front().levels);
  for (const Assembly& one : assemblies) {
    if (has(one.levels) == first) continue;
    throw InputError(fmt::format("{} of assembly '{}'", what, one.name),
                     InputState{first ? "missing" : "given"},
                     fmt::format("must be given of all assemblies or of none; that of '{}' is{}",
                                 assemblies.front().name, first ? "" : " not"),
                     "Leave the column out, or complete it.");
  }
}

double log_mean_secant(const LevelEvidence& levels) {
  double sum = 0.0;
  for (const double k : levels.levels().secant_stiffness) sum += k;
  return std::log(sum / static_cast<double>(levels.size()));
}

}  // namespace

void check_assemblies(std::span<const Assembly> assemblies, std::optional<double> stiffness) {
  if (assemblies.size() < kFewestAssemblies) {
    throw InputError("number of assemblies", static_cast<double>(assemblies.size()),
                     fmt::format("must be {} or more: fewer tell hardly by how much the next one "
                                 "may differ",
                                 kFewestAssemblies),
                     "Measure more assemblies, or identify the levels together as of one joint.");
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
                     "are not among what is drawn of several assemblies", "Leave them out.");
  }
  (void)stiffness_of_assemblies(assemblies, stiffness);
}

StiffnessOfAssemblies stiffness_of_assemblies(std::span<const Assembly> assemblies,
                                              std::optional<double> stiffness) {
  if (stiffness) check_stiffness(*stiffness);
  const auto own = std::ranges::count_if(
      assemblies, [](const Assembly& one) { return one.stiffness.has_value(); });
  for (const Assembly& one : assemblies) {
    if (one.stiffness) check_stiffness(*one.stiffness);
    if (own == 0 || one.stiffness) continue;
    throw InputError(fmt::format("stiffness of assembly '{}'", one.name), InputState{"missing"},
                     "must be given of all assemblies or of none", "Complete the column.");
  }
  StiffnessOfAssemblies known;
  known.log_stiffness = Eigen::VectorXd::Zero(std::ssize(assemblies));
  if (own > 0) {
    if (stiffness) {
      throw InputError("stiffness", *stiffness, "is given of each assembly, too",
                       "Leave one of them out.");
    }
    for (Eigen::Index j = 0; j < known.log_stiffness.size(); ++j) {
      known.log_stiffness(j) = std::log(*assemblies[static_cast<std::size_t>(j)].stiffness);
    }
  } else if (!stiffness) {
    throw InputError("stiffness", InputState{"missing"}, "must be given: slip forces are k times A",
                     "Give k of each assembly, or one of all.");
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
