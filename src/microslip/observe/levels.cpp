// SPDX-License-Identifier: MIT
#include "microslip/observe/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Column = std::vector<double>;

void check_column(std::string_view name, const Column& values, std::size_t size, bool required,
                  bool zero_allowed) {
  if (values.empty() && !required) return;
  if (values.size() != size) {
    throw InputError(fmt::format("length of {}", name), static_cast<double>(values.size()),
                     fmt::format("must be the number of levels, {}", size));
  }
  for (std::size_t i = 0; i < size; ++i) {
    const double value = values[i];
    if (std::isfinite(value) && (zero_allowed ? value >= 0.0 : value > 0.0)) continue;
    throw InputError(
        fmt::format("{} of level {}", name, i + 1), value,
        zero_allowed ? "must be 0 or more, and finite" : "must be positive and finite");
  }
}

/// Mean of the values of equal levels and its standard deviation (empty columns stay empty).
void merge_measured(const Column& values, const Column& deviations,
                    std::span<const std::size_t> group, Column& merged, Column& merged_deviations) {
  if (values.empty()) return;
  if (group.size() == 1) {  // as it was given, to the last digit
    merged.push_back(values[group[0]]);
    if (!deviations.empty()) merged_deviations.push_back(deviations[group[0]]);
    return;
  }
  // A zero deviation means "exact"; a weight needs a positive one, so the group is then averaged.
  const bool weighted = !deviations.empty() && std::ranges::all_of(group, [&](std::size_t i) {
    return deviations[i] > 0.0;
  });
  double weight_sum = 0.0;
  double sum = 0.0;
  double variance_sum = 0.0;
  for (const std::size_t i : group) {
    const double weight = weighted ? 1.0 / (deviations[i] * deviations[i]) : 1.0;
    weight_sum += weight;
    sum += weight * values[i];
    if (!deviations.empty()) variance_sum += weight * weight * deviations[i] * deviations[i];
  }
  merged.push_back(sum / weight_sum);
  if (!deviations.empty()) merged_deviations.push_back(std::sqrt(variance_sum) / weight_sum);
}

double spread_about(double mean, const Column& values, std::span<const std::size_t> group) {
  double sum = 0.0;
  for (const std::size_t i : group) sum += (values[i] - mean) * (values[i] - mean);
  return group.size() > 1 ? sum : 0.0;
}

}  // namespace

std::optional<double> MergedLevels::repeat_scatter() const {
  double sum = 0.0;
  std::size_t freedom = 0;
  for (std::size_t i = 0; i < count.size(); ++i) {
    const double mean = levels.dissipation[i];
    if (count[i] == 1 || mean == 0.0) continue;
    sum += dissipation_spread[i] / (mean * mean);
    freedom += count[i] - 1;
  }
  if (freedom == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(freedom));
}

void check_levels(const Levels& levels) {
  const std::size_t n = levels.size();
  if (n == 0) throw InputError("number of levels", 0.0, "must be at least 1");
  check_column("amplitude", levels.amplitude, n, true, false);
  check_column("dissipation", levels.dissipation, n, true, true);
  check_column("amplitude_std", levels.amplitude_std, n, false, true);
  check_column("dissipation_std", levels.dissipation_std, n, false, true);
  check_column("secant_stiffness", levels.secant_stiffness, n, false, false);
  check_column("secant_stiffness_std", levels.secant_stiffness_std, n, false, true);
  check_column("linear_dissipation", levels.linear_dissipation, n, false, true);
  check_column("frequency", levels.frequency, n, false, false);
  check_column("frequency_std", levels.frequency_std, n, false, true);
}

MergedLevels sort_and_merge(const Levels& levels) {
  check_levels(levels);
  std::vector<std::size_t> order(levels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return levels.amplitude[i]; });
  MergedLevels merged;
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    const double amplitude = levels.amplitude[order[begin]];
    while (end < order.size() && levels.amplitude[order[end]] == amplitude) ++end;
    const auto group = std::span(order).subspan(begin, end - begin);
    Levels& out = merged.levels;
    out.amplitude.push_back(amplitude);
    if (!levels.amplitude_std.empty()) {
      out.amplitude_std.push_back(levels.amplitude_std[order[begin]]);
    }
    merge_measured(levels.dissipation, levels.dissipation_std, group, out.dissipation,
                   out.dissipation_std);
    merge_measured(levels.secant_stiffness, levels.secant_stiffness_std, group,
                   out.secant_stiffness, out.secant_stiffness_std);
    merge_measured(levels.frequency, levels.frequency_std, group, out.frequency, out.frequency_std);
    Column none;
    merge_measured(levels.linear_dissipation, {}, group, out.linear_dissipation, none);
    merged.count.push_back(group.size());
    merged.dissipation_spread.push_back(
        spread_about(out.dissipation.back(), levels.dissipation, group));
    begin = end;
  }
  return merged;
}

}  // namespace microslip
