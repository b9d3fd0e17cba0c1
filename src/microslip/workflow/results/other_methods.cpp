// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/other_methods.hpp"

#include <cstddef>

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
  const LevelEvidence evidence(levels);
  if (evidence.size() < kFewestLevels) return std::nullopt;
  return compare_methods(evidence, *stiffness, results.options,
                         results.joint ? results.joint->linear_damping : std::optional<double>());
}

MeasuredSlopes measured_slopes(const MethodComparison& methods) {
  const Levels& levels = methods.net_evidence.levels();
  MeasuredSlopes slopes;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    slopes.differences.x.push_back(0.5 * (levels.amplitude[i] + levels.amplitude[i - 1]));
    slopes.differences.y.push_back((levels.dissipation[i] - levels.dissipation[i - 1]) /
                                   (levels.amplitude[i] - levels.amplitude[i - 1]));
  }
  slopes.spline.x = equal_ratios(levels.amplitude.front(), levels.amplitude.back());
  for (const double a : slopes.spline.x) {
    slopes.spline.y.push_back(methods.spline.fit.spline.first_derivative(a));
  }
  return slopes;
}

std::vector<VariedSmoothing> varied_inversions(const MethodComparison& methods) {
  std::vector<VariedSmoothing> all;
  for (const double factor : {100.0, 10.0, 1.0, 0.1, 0.01}) {
    all.push_back({factor, factor == 1.0 ? methods.inversion : inversion_with(methods, factor)});
  }
  return all;
}

std::vector<VariedSmoothing> varied_splines(const MethodComparison& methods) {
  std::vector<VariedSmoothing> all;
  for (const double factor : {0.01, 1.0, 100.0}) {
    all.push_back({factor, spline_with(methods, factor)});
  }
  return all;
}

}  // namespace microslip
