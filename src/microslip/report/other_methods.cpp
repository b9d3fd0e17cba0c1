// SPDX-License-Identifier: MIT
#include <cstddef>

#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

/// The levels without those that are left out.
Levels used_levels(const MeasuredLevels& test) {
  Levels used;
  const auto take = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (test.left_out.empty() || !test.left_out[i]) to.push_back(from[i]);
    }
  };
  take(test.levels.amplitude, used.amplitude);
  take(test.levels.dissipation, used.dissipation);
  take(test.levels.amplitude_std, used.amplitude_std);
  take(test.levels.dissipation_std, used.dissipation_std);
  take(test.levels.secant_stiffness, used.secant_stiffness);
  take(test.levels.secant_stiffness_std, used.secant_stiffness_std);
  return used;
}

std::optional<double> stiffness_of(const ExperimentResults& results) {
  if (results.joint) return results.joint->joint.stiffness();
  return results.rig ? results.rig->contact.stiffness : std::nullopt;
}

}  // namespace

std::optional<MethodComparison> compare_methods(const ExperimentResults& results) {
  const std::optional<double> stiffness = stiffness_of(results);
  if (!results.levels || !stiffness) return std::nullopt;
  const Levels levels = used_levels(*results.levels);
  if (sort_and_merge(levels).levels.size() < kFewestLevels) return std::nullopt;
  IdentificationOptions options = results.options;
  options.inversion.stiffness = *stiffness;
  return compare_methods(levels, options,
                         results.joint ? results.joint->linear_damping : std::optional<double>());
}

}  // namespace microslip
