// SPDX-License-Identifier: MIT
#include "microslip/identify/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace microslip {
namespace {

constexpr std::size_t kEnoughLevels = 10;
constexpr double kLowestScore = -3.5;   // standard deviations
constexpr double kMostAreaCost = 12.0;  // of χ² with 1 degree of freedom: below 0.1 %
constexpr double kMostExtrapolated = 0.25;
constexpr double kMostDampingShare = 0.5;
constexpr double kLargeScatter = 0.2;  // relative
constexpr double kBendScore = -4.0;
constexpr double kMostSecantOffset = 0.05;  // of k

void diagnose_zero_std(std::string_view name, const std::vector<double>& deviations,
                       std::vector<Warning>& warnings) {
  const auto zero = std::ranges::find(deviations, 0.0);
  if (zero == deviations.end()) return;
  warnings.push_back(
      {"std_ignored", fmt::format("{} is 0 at level {}, which cannot be; the whole column is left "
                                  "out. Give the scatter of every level, or remove the column.",
                                  name, zero - deviations.begin() + 1)});
}

/// Second divided difference at inner levels over its standard deviation; the lowest counts.
void diagnose_convexity(const InversionResult& result, std::vector<Warning>& warnings) {
  const std::vector<double>& a = result.levels.amplitude;
  const std::vector<double>& d = result.levels.dissipation;
  const auto deviation = [&](std::size_t i) {
    return result.scatter * (result.scatter_is_relative ? result.fitted_dissipation[i]
                                                        : result.levels.dissipation_std[i]);
  };
  double lowest = 0.0;
  std::size_t where = 0;
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    const double left = (a[i + 1] - a[i]) / (a[i + 1] - a[i - 1]);
    const double right = 1.0 - left;
    const double bend = left * d[i - 1] + right * d[i + 1] - d[i];
    const double spread =
        std::hypot(left * deviation(i - 1), right * deviation(i + 1), deviation(i));
    if (spread > 0.0 && bend / spread < lowest) {
      lowest = bend / spread;
      where = i;
    }
  }
  if (lowest > kBendScore) return;
  warnings.push_back(
      {"data_not_convex",
       fmt::format(
           "D at A = {:.4g} m lies {:.1f} standard deviations above the line through its "
           "neighbours, but D of a joint under constant load is convex. Look at that level: "
           "a wrong amplitude, another session, or a normal load that changed.",
           a[where], -lowest)});
}

void diagnose_scatter(const InversionResult& result, std::vector<Warning>& warnings) {
  if (result.scatter_is_relative) {
    if (result.scatter > kLargeScatter) {
      warnings.push_back({"scatter_large",
                          fmt::format("D scatters by {:.0f} % about the fit; the density is hardly "
                                      "more than its smoothing. Check the levels for outliers.",
                                      100.0 * result.scatter)});
    }
    return;
  }
  if (result.scatter > 2.0) {
    warnings.push_back(
        {"scatter_large", fmt::format("The levels scatter {:.1f} times as much about the fit as "
                                      "dissipation_std says. The bands follow the scatter found.",
                                      result.scatter)});
  } else if (result.scatter < 0.3) {
    warnings.push_back({"scatter_small",
                        fmt::format("The levels scatter only {:.2f} times as much about the fit as "
                                    "dissipation_std says. The bands follow the scatter found.",
                                    result.scatter)});
  }
}

/// Area below the lowest amplitude: the first knot at or above kA_min ends the sum.
double area_below(const InversionResult& result, double slip_force) {
  double area = 0.0;
  for (std::size_t j = 1; j < result.slip_force.size(); ++j) {
    if (result.slip_force[j] > slip_force) break;
    area += 0.5 * (result.slip_force[j] - result.slip_force[j - 1]) *
            (result.density[j] + result.density[j - 1]);
  }
  return area;
}

void diagnose_ends(const InversionResult& result, const InversionOptions& options,
                   std::vector<Warning>& warnings) {
  const double lowest = options.stiffness * result.levels.amplitude.front();
  const double below = area_below(result, lowest);
  if (below > kMostExtrapolated * result.area) {
    warnings.push_back(
        {"extrapolation",
         fmt::format("{:.0f} % of the identified area lies below {:.3g} N, the slip force of the "
                     "lowest amplitude, where the levels tell only two moments of the density: its "
                     "shape there is an assumption. Measure at lower levels.",
                     100.0 * below / result.area, lowest)});
  }
  if (!result.linear_damping) return;
  const double a = result.levels.amplitude.front();
  const double share = *result.linear_damping * a * a / result.fitted_dissipation.front();
  if (share > kMostDampingShare) {
    warnings.push_back({"damping_ambiguous",
                        fmt::format("Linear damping takes {:.0f} % of D at the lowest level. There "
                                    "it can hardly be told from slip at small forces; subtract "
                                    "linear damping measured without the joint if you can.",
                                    100.0 * share)});
  }
}

}  // namespace

std::vector<Warning> diagnose(const Levels& levels) {
  std::vector<Warning> warnings;
  const MergedLevels merged = sort_and_merge(levels);
  const std::size_t distinct = merged.levels.size();
  if (distinct < kEnoughLevels) {
    warnings.push_back(
        {"few_levels", fmt::format("Only {} different amplitudes: what is seen of the density is "
                                   "broad features at most. 40 or more levels resolve its shape.",
                                   distinct)});
  }
  if (distinct < levels.size()) {
    warnings.push_back(
        {"amplitudes_merged", fmt::format("{} levels have {} different amplitudes; equal ones were "
                                          "averaged into one level each.",
                                          levels.size(), distinct)});
  }
  diagnose_zero_std("dissipation_std", levels.dissipation_std, warnings);
  diagnose_zero_std("secant_stiffness_std", levels.secant_stiffness_std, warnings);
  if (!levels.amplitude_std.empty() && levels.dissipation_std.empty()) {
    warnings.push_back(
        {"std_ignored",
         "amplitude_std says something only beside dissipation_std: without that the "
         "scatter is estimated from D. Give both, or neither."});
  }
  return warnings;
}

std::vector<Warning> diagnose(const InversionResult& result, const InversionOptions& options) {
  std::vector<Warning> warnings;
  if (result.lowest_score < kLowestScore) {
    warnings.push_back(
        {"density_negative",
         fmt::format(
             "D asks for a negative density at {:.3g} N, by {:.1f} standard deviations, which "
             "no joint under constant normal load can be. Did the normal "
             "load vary over the cycle or between levels, or is something other than the "
             "joint in D?",
             result.lowest_at, -result.lowest_score)});
  }
  diagnose_convexity(result, warnings);
  if (result.area_cost > kMostAreaCost) {
    warnings.push_back(
        {"stiffness_inconsistent",
         fmt::format(
             "More stiffness slips than k = {:.4g} N/m has: the area would be {:.3f}, above "
             "1. k is too low (try {:.4g} N/m or more), or D too large or A too small.",
             options.stiffness, result.unlimited_area, options.stiffness * result.unlimited_area)});
  }
  if (std::abs(result.secant_offset) > kMostSecantOffset * options.stiffness) {
    warnings.push_back(
        {"secant_inconsistent",
         fmt::format(
             "The secant stiffnesses are {:.3g} N/m, {:.0f} % of k, off what D and k give on "
             "average: k = {:.4g} N/m would agree. Only their change over the amplitude was "
             "used.",
             result.secant_offset, 100.0 * result.secant_offset / options.stiffness,
             options.stiffness + result.secant_offset)});
  }
  diagnose_scatter(result, warnings);
  diagnose_ends(result, options, warnings);
  if (options.atom && !result.atom_slip_force) {
    warnings.push_back({"macroslip_not_reached",
                        "No atom was identified: fewer than 20 levels, or they do not show D "
                        "growing in a straight line, as it does in macro-slip."});
  }
  return warnings;
}

}  // namespace microslip
