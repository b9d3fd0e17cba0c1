// SPDX-License-Identifier: MIT
#include "microslip/identify/methods/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/plausibility.hpp"
#include "microslip/identify/evidence/stiffness_evidence.hpp"
#include "microslip/observe/neighbour_scatter.hpp"

namespace microslip {
namespace {

constexpr std::size_t kEnoughLevels = 10;
constexpr double kLowestScore = -3.5;   // standard deviations
constexpr double kMostAreaCost = 12.0;  // of χ² with 1 degree of freedom: below 0.1 %
constexpr double kMostExtrapolated = 0.25;
constexpr double kMostDampingShare = 0.5;
constexpr double kLargeScatter = 0.2;  // relative
constexpr double kBendScore = -4.0;
constexpr double kRepeatsDiffer = 4.0;         // times the scatter from amplitude to amplitude
constexpr double kLeastDifference = 0.01;      // relative to D
constexpr double kLeastSlip = 0.01;            // area
constexpr double kNarrowRange = 1.5;           // highest over lowest amplitude
constexpr double kDampingRange = 2.0;          // the same, from which A² and A³ are distinguished
constexpr double kAsScatter = 1.3;             // times the residual of the fit
constexpr double kExponentMargin = 0.1;        // from 2
constexpr double kExponentScore = 3.0;         // standard deviations
constexpr double kDissipationRounding = 1e-6;  // relative to D
/// Where no standard deviation was given, that of a low level counts as a share of its D.
constexpr double kLeastEffective = 0.03;  // of the draws of a band

constexpr std::string_view kGiveStd =
    " If D of low levels hardly exceeds its noise, give dissipation_std.";

void diagnose_zero_std(std::string_view name, const std::vector<double>& deviations,
                       std::vector<Warning>& warnings) {
  const auto zero = std::ranges::find(deviations, 0.0);
  if (zero == deviations.end()) return;
  warnings.push_back(
      {"std_ignored", fmt::format("{} is 0 at level {}, which is impossible; the whole column is "
                                  "ignored. Give the scatter of every level, or remove the column.",
                                  name, zero - deviations.begin() + 1)});
}

/// A result with the levels that were inverted.
struct Inverted {
  const LevelEvidence& evidence;
  const InversionResult& result;
  double stiffness;  ///< k, N/m

  [[nodiscard]] const Levels& levels() const { return evidence.levels(); }

  /// Standard deviation of D of each level, J.
  [[nodiscard]] std::vector<double> deviations() const {
    LevelPrediction prediction;
    prediction.value.dissipation = result.fitted_dissipation;
    return evidence.deviations(prediction, {.dissipation = result.dissipation_scatter}).dissipation;
  }
};

/// Second divided difference at inner levels over its standard deviation; the lowest counts.
void diagnose_convexity(const Inverted& inverted, std::vector<Warning>& warnings) {
  const std::vector<double>& a = inverted.levels().amplitude;
  const std::vector<double>& d = inverted.levels().dissipation;
  const std::vector<double> deviation = inverted.deviations();
  double lowest = 0.0;
  std::size_t where = 0;
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    const double left = (a[i + 1] - a[i]) / (a[i + 1] - a[i - 1]);
    const double right = 1.0 - left;
    const double bend = left * d[i - 1] + right * d[i + 1] - d[i];
    const double spread =
        std::hypot(left * deviation[i - 1], right * deviation[i + 1], deviation[i]);
    if (spread > 0.0 && bend / spread < lowest) {
      lowest = bend / spread;
      where = i;
    }
  }
  if (lowest > kBendScore) return;
  warnings.push_back(
      {"data_not_convex",
       fmt::format("D at A = {:.4g} m lies {:.1f} standard deviations above the line through its "
                   "neighbours, but D of a joint under constant load is convex. Check that level: "
                   "a wrong amplitude, another session, or a changed normal load.",
                   a[where], -lowest)});
}

void diagnose_scatter(const InversionResult& result, std::vector<Warning>& warnings) {
  const double scatter = result.dissipation_scatter;
  if (result.scatter_is_relative) {
    if (scatter > kLargeScatter) {
      warnings.push_back({"scatter_large",
                          fmt::format("D scatters by {:.0f} % about the fit; the density is hardly "
                                      "more than its smoothing. Check the levels for outliers.{}",
                                      100.0 * scatter, kGiveStd)});
    }
    return;
  }
  const double secant = result.secant_scatter.value_or(0.0);
  if (scatter > 2.0 || secant > 2.0) {
    const std::string found =
        result.secant_scatter
            ? fmt::format("D scatters {:.1f} and k_eq {:.1f} times", scatter, secant)
            : fmt::format("D scatters {:.1f} times", scatter);
    warnings.push_back(
        {"scatter_large",
         fmt::format(
             "{} as much about the fit as the standard deviations state. The bands use the scatter "
             "found. A wrong loss factor of the structure does this too: too much or too little is "
             "subtracted from D. The bands then need the standard deviation of the loss factor.",
             found)});
  } else if (scatter < 0.3) {
    warnings.push_back(
        {"scatter_small", fmt::format("D scatters only {:.2f} times as much about the fit as its "
                                      "standard deviation states. The bands use the scatter found.",
                                      scatter)});
  }
}

/// Scatter of log D about a smooth curve; nothing where there are too few levels, or some without
/// D.
std::optional<double> scatter_of_curve(const Levels& levels) {
  const auto is_positive = [](double d) { return d > 0.0; };
  if (levels.size() < 5 || !std::ranges::all_of(levels.dissipation, is_positive)) {
    return std::nullopt;
  }
  const LevelEvidence alone({.amplitude = levels.amplitude, .dissipation = levels.dissipation});
  return alone.expected_scatter(0.0).dissipation;
}

/// Sessions that differ as a whole: each is a smooth curve, and so is their mean.
void diagnose_repeats(const MergedLevels& merged, std::vector<Warning>& warnings) {
  const std::optional<double> repeats = merged.repeat_scatter();
  const std::optional<double> curve = scatter_of_curve(merged.levels);
  if (!repeats || !curve) return;
  if (*repeats < std::max(kLeastDifference, kRepeatsDiffer * *curve)) return;
  warnings.push_back(
      {"repeats_differ",
       fmt::format(
           "D of levels repeated at one amplitude differs by {} ({} from amplitude to amplitude): "
           "the joint changed between the sessions. The bands count it as independent scatter, "
           "which it is not; identify each session separately and compare.",
           percent_text(*repeats), percent_text(*curve))});
}

/// An error of k moves all k_eq alike, and the resonances with them.
void diagnose_stiffness(const InversionResult& result, double stiffness, SecantOf secant,
                        std::vector<Warning>& warnings) {
  if (result.fitted_secant_stiffness.empty()) {
    if (result.area >= kLeastSlip) return;
    warnings.push_back(
        {"stiffness_unchecked",
         fmt::format("Only {} of k = {:.4g} N/m slips, and without secant stiffnesses the levels "
                     "cannot show whether k is right. Check k and its unit.",
                     percent_text(result.area), stiffness)});
    return;
  }
  if (secant == SecantOf::kFinal) return;
  const SecantEvidence evidence{result.secant_offset, result.secant_offset_std,
                                result.secant_scatter};
  auto offset = diagnose_offset(evidence, stiffness, 1.0 - result.area);
  if (offset) warnings.push_back(std::move(*offset));
}

/// The p of D ∝ A^p by the lines of least squares through ln D over ln A, with its standard
/// deviation; nothing where the levels are too few or too close.
struct Exponent {
  double value;
  double std;
};

std::optional<Exponent> exponent_of(std::span<const double> amplitude,
                                    std::span<const double> dissipation) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    if (!(dissipation[i] > 0.0)) continue;
    x.push_back(std::log(amplitude[i]));
    y.push_back(std::log(dissipation[i]));
  }
  constexpr std::size_t kFewest = 4;
  if (x.size() < kFewest) return std::nullopt;
  const auto n = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += std::pow(x[i] - mean_x, 2);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(xx > 0.0)) return std::nullopt;
  double left = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    left += std::pow(y[i] - mean_y - xy / xx * (x[i] - mean_x), 2);
  }
  return Exponent{xy / xx, std::sqrt(left / (n - 2.0) / xx)};
}

double exponent_margin(const Exponent& exponent) {
  return std::max(kExponentMargin, kExponentScore * exponent.std);
}

/// An exponent below 2, the least of micro-slip and linear damping. A joint that the levels follow
/// into macro-slip is no such case: its D begins above A².
void diagnose_exponent(const Levels& merged, std::vector<Warning>& warnings) {
  const std::vector<double>& a = merged.amplitude;
  if (a.back() < kDampingRange * a.front()) return;
  const auto middle = static_cast<std::size_t>(
      std::ranges::upper_bound(a, std::sqrt(a.front() * a.back())) - a.begin());
  const auto all = exponent_of(a, merged.dissipation);
  const auto lower =
      exponent_of(std::span(a).first(middle), std::span(merged.dissipation).first(middle));
  if (!all || !lower) return;
  if (all->value >= 2.0 - exponent_margin(*all) || lower->value >= 2.0 - kExponentMargin) return;
  warnings.push_back(
      {"exponent_below_two",
       fmt::format("D grows as A^{:.2f} (± {:.2g}), less than A²: neither linear damping (A²) nor "
                   "micro-slip in this range (more than A²) does. Either what slips below the "
                   "lowest amplitude nears macro-slip (A^1), and D does not determine its density, "
                   "or D has an error: an offset, another gain at low levels, or a changed load. "
                   "Measure at lower levels.",
                   all->value, all->std)});
}

/// Whether βA² alone fits D as well as the density. Measured secant stiffnesses distinguish slip
/// from it.
bool is_as_linear_damping(const Inverted& inverted) {
  const InversionResult& result = inverted.result;
  const std::vector<double>& a = inverted.levels().amplitude;
  const std::vector<double>& d = inverted.levels().dissipation;
  if (!result.fitted_secant_stiffness.empty()) return false;
  if (a.size() < kEnoughLevels || a.back() < kDampingRange * a.front()) return false;
  const std::vector<double> deviation = inverted.deviations();
  const auto scale = [&](std::size_t i) {
    return std::max(deviation[i], kDissipationRounding * result.fitted_dissipation[i]);
  };
  double slope = 0.0;
  double norm = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i] * a[i] / scale(i);
    slope += x * d[i] / scale(i);
    norm += x * x;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += std::pow((d[i] - slope / norm * a[i] * a[i]) / scale(i), 2);
  }
  return sum <= std::pow(kAsScatter, 2) * static_cast<double>(a.size());
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

void diagnose_damping(const Inverted& inverted, std::vector<Warning>& warnings) {
  const Levels& levels = inverted.levels();
  const auto exponent = exponent_of(levels.amplitude, levels.dissipation);
  if (!exponent || std::abs(exponent->value - 2.0) > exponent_margin(*exponent)) return;
  if (!is_as_linear_damping(inverted)) return;
  warnings.push_back(
      {"damping_suspected",
       fmt::format(
           "D grows as A^{:.2f} (± {:.2g}) throughout, as linear damping does (A²): D alone cannot "
           "distinguish it from slip. Subtract the damping of the structure, identify it with the "
           "joint (linear damping), or give secant stiffnesses, which slip lowers.",
           exponent->value, exponent->std)});
}

void diagnose_ends(const Inverted& inverted, std::vector<Warning>& warnings) {
  const InversionResult& result = inverted.result;
  const double a = inverted.levels().amplitude.front();
  const double lowest = inverted.stiffness * a;
  const double below = area_below(result, lowest);
  if (below > kMostExtrapolated * result.area) {
    warnings.push_back(
        {"extrapolation",
         fmt::format("{:.0f} % of the identified area lies below {:.3g} N, the slip force of the "
                     "lowest amplitude, where the levels determine only two moments of the "
                     "density: its shape there is an assumption. Measure at lower levels.",
                     100.0 * below / result.area, lowest)});
  }
  if (!result.linear_damping) {
    diagnose_damping(inverted, warnings);
    return;
  }
  const double share = *result.linear_damping * a * a / result.fitted_dissipation.front();
  if (share > kMostDampingShare) {
    warnings.push_back(
        {"damping_ambiguous",
         fmt::format("Linear damping accounts for {:.0f} % of D at the lowest level. There it can "
                     "hardly be distinguished from slip at small forces; subtract linear damping "
                     "measured without the joint if you can.",
                     100.0 * share)});
  }
}

void check_levels_of(const InversionResult& result, const LevelEvidence& evidence) {
  if (result.fitted_dissipation.size() == evidence.size()) return;
  throw InputError("number of levels of the result",
                   static_cast<double>(result.fitted_dissipation.size()),
                   fmt::format("must be {}, as many as the evidence has", evidence.size()),
                   "Take the evidence that was inverted.");
}

}  // namespace

std::vector<Warning> diagnose(const LevelEvidence& evidence) {
  std::vector<Warning> warnings;
  const MergedLevels& merged = evidence.merged();
  const std::size_t distinct = merged.levels.size();
  if (distinct < kEnoughLevels) {
    warnings.push_back(
        {"few_levels", fmt::format("Only {} different amplitudes: they resolve broad features of "
                                   "the density at most. 40 or more levels resolve its shape.",
                                   distinct)});
  }
  const std::vector<double>& amplitude = merged.levels.amplitude;
  if (distinct > 1 && amplitude.back() < kNarrowRange * amplitude.front()) {
    warnings.push_back(
        {"narrow_range",
         fmt::format("The amplitudes reach from {:.4g} to {:.4g} m only: the shape of D determines "
                     "the density only between kA of these. Measure at lower and higher levels.",
                     amplitude.front(), amplitude.back())});
  }
  std::ranges::move(diagnose_beside_others(evidence), std::back_inserter(warnings));
  return warnings;
}

std::vector<Warning> diagnose_beside_others(const LevelEvidence& evidence) {
  std::vector<Warning> warnings;
  const Levels& levels = evidence.measured();
  const MergedLevels& merged = evidence.merged();
  const std::size_t distinct = merged.levels.size();
  if (distinct < levels.size()) {
    warnings.push_back(
        {"amplitudes_merged", fmt::format("{} levels have {} different amplitudes; equal ones were "
                                          "averaged into one level each.",
                                          levels.size(), distinct)});
  }
  diagnose_exponent(merged.levels, warnings);
  diagnose_zero_std("dissipation_std", levels.dissipation_std, warnings);
  diagnose_zero_std("secant_stiffness_std", levels.secant_stiffness_std, warnings);
  diagnose_repeats(merged, warnings);
  if (!levels.amplitude_std.empty() && levels.dissipation_std.empty()) {
    warnings.push_back({"std_ignored",
                        "amplitude_std is used only together with dissipation_std: without that "
                        "the scatter is estimated from D. Give both, or neither."});
  }
  warn_of_implausible("The largest amplitude", kLength, levels.amplitude, warnings);
  warn_of_implausible("The largest dissipation", kEnergy, levels.dissipation, warnings);
  return warnings;
}

std::vector<Warning> diagnose(const InversionResult& result, const LevelEvidence& evidence,
                              double stiffness, const InversionOptions& options, SecantOf secant) {
  result.check();
  check_levels_of(result, evidence);
  const Inverted inverted{evidence, result, stiffness};
  std::vector<Warning> warnings;
  if (result.lowest_score < kLowestScore) {
    warnings.push_back(
        {"density_negative",
         fmt::format(
             "D requires a negative density at {:.3g} N, by {:.1f} standard deviations, which no "
             "joint under constant normal load can have. Did the normal load vary over the cycle "
             "or between levels, or does D contain something other than the joint?{}",
             result.lowest_at, -result.lowest_score, result.scatter_is_relative ? kGiveStd : "")});
  }
  diagnose_convexity(inverted, warnings);
  if (result.area_cost > kMostAreaCost) {
    warnings.push_back(
        {"stiffness_inconsistent",
         fmt::format(
             "More stiffness slips than k = {:.4g} N/m has: the area would be {:.3f}, above "
             "1. k is too low (try {:.4g} N/m or more), or D too large or A too small.",
             stiffness, result.unlimited_area, stiffness * result.unlimited_area)});
  }
  diagnose_stiffness(result, stiffness, secant, warnings);
  diagnose_scatter(result, warnings);
  diagnose_ends(inverted, warnings);
  if (result.inner_not_converged > 0) {
    warnings.push_back(
        {"inner_not_converged",
         fmt::format("{} of {} inner solutions did not converge: the choice of the smoothing, the "
                     "search for an atom and the warnings of a negative density or of too much "
                     "area depend on them. Do not rely on these; another number of levels or a "
                     "smoothing parameter that you give may help.",
                     result.inner_not_converged, result.inner_solutions)});
  }
  if (options.atom && !result.atom_slip_force) {
    warnings.push_back({"macroslip_not_reached",
                        "No atom was identified: fewer than 20 levels, or they do not show D "
                        "growing linearly, as it does in macro-slip."});
  }
  return warnings;
}

std::vector<Warning> diagnose(const DensityBands& bands) {
  if (bands.effective_samples >= kLeastEffective * static_cast<double>(bands.samples)) return {};
  return {
      {"bands_not_converged", fmt::format("the {} samples of the band are worth {:.0f} independent "
                                          "ones where fewest. The band is rough: draw more.",
                                          bands.samples, bands.effective_samples)}};
}

}  // namespace microslip
