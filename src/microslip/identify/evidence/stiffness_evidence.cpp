// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/stiffness_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

#include "microslip/base/percent.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

constexpr double kMostOffset = 0.01;        // of k, about as well as it is known
constexpr double kSignificantOffset = 3.0;  // standard deviations
constexpr double kMostScatter = 2.0;        // standard deviations
/// Drives of 0.1 Hz steps at 55 Hz jump by up to 0.2 %.
constexpr double kMostChange = 3e-3;
constexpr double kMostChangeOfKnown = 1e-3;
/// Standard deviations of each of two levels: their sum is more than four of the difference, as
/// there are many pairs.
constexpr double kSignificantChange = 3.0;
constexpr double kMicrometre = 1e-6;
/// Joints that are tried for the softening that the others do not explain, and the levels of which
/// all pairs are looked at; more determine their joint.
constexpr std::size_t kSofterJoints = 12;
constexpr std::size_t kMostForPairs = 100;

std::optional<SecantEvidence> secant_evidence(const LevelEvidence& levels, const Joint& joint) {
  const std::vector<double>& measured = levels.levels().secant_stiffness;
  if (measured.empty()) return std::nullopt;
  const LevelRows predicted = levels.predict(joint);
  const std::vector<double> sigma =
      levels.deviations({.value = predicted}, levels.expected_scatter(joint.stiffness()))
          .secant_stiffness;
  const std::size_t n = measured.size();
  double weights = 0.0;
  double sum = 0.0;
  double common = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double weight = 1.0 / (sigma[i] * sigma[i]);
    weights += weight;
    sum += weight * (measured[i] - predicted.secant_stiffness[i]);
    common += weight * sigma[i];
  }
  SecantEvidence evidence;
  evidence.offset = sum / weights;
  const bool given = levels.secant_std_given();
  evidence.offset_std = given ? common / weights : 1.0 / std::sqrt(weights);
  if (!given || n < 2) return evidence;
  double square = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double left = measured[i] - predicted.secant_stiffness[i] - evidence.offset;
    square += std::pow(left / sigma[i], 2);
  }
  evidence.scatter = std::sqrt(square / static_cast<double>(n - 1));
  return evidence;
}

/// The levels by rising amplitude: ln f, its σ, and the most that the joint's softening changes
/// it.
struct Frequencies {
  std::vector<double> amplitude;
  std::vector<double> frequency;
  std::vector<double> log;
  std::vector<double> deviation;  // of the logarithm; zeros where it is not known
  std::vector<double> softening;  // ½ ln(k_eq/k_eq(A_1)) ≤ 0
  bool known = false;             // whether deviations were given

  Frequencies(const Levels& levels, const Joint& joint) {
    std::vector<std::size_t> order(levels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return levels.amplitude[i]; });
    known = !levels.frequency_std.empty();
    const double first = secant_stiffness(joint, levels.amplitude[order.front()]);
    for (const std::size_t i : order) {
      amplitude.push_back(levels.amplitude[i]);
      frequency.push_back(levels.frequency[i]);
      log.push_back(std::log(levels.frequency[i]));
      deviation.push_back(known ? levels.frequency_std[i] / levels.frequency[i] : 0.0);
      const double k = secant_stiffness(joint, levels.amplitude[i]);
      softening.push_back(std::min(0.0, 0.5 * std::log(k / first)));
    }
  }

  [[nodiscard]] std::size_t size() const { return log.size(); }
};

/// The change between two levels, of which so much of ln f is beyond its deviations.
FrequencyChange change_between(const Frequencies& levels, std::size_t from, std::size_t to,
                               double excess) {
  const double limit = std::log1p(levels.known ? kMostChangeOfKnown : kMostChange);
  const double margin = kSignificantChange * (levels.deviation[from] + levels.deviation[to]);
  return {.from = levels.amplitude[from],
          .to = levels.amplitude[to],
          .from_frequency = levels.frequency[from],
          .to_frequency = levels.frequency[to],
          .change = levels.frequency[to] / levels.frequency[from] - 1.0,
          .explained = std::expm1(levels.softening[to] - levels.softening[from]),
          .beyond = from == to ? 0.0 : std::max(0.0, std::expm1(excess + margin)),
          .limit = std::expm1(limit + margin),
          .significant = excess > limit};
}

/// The pair of levels between which `value` rises most, its deviations subtracted.
FrequencyChange largest_rise(const Frequencies& levels, const std::vector<double>& value) {
  std::size_t lowest = 0;
  std::size_t from = 0;
  std::size_t to = 0;
  double most = -std::numeric_limits<double>::infinity();
  const auto margin = [&](std::size_t i) { return kSignificantChange * levels.deviation[i]; };
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const double rise = (value[i] - margin(i)) - (value[lowest] + margin(lowest));
    if (rise > most) {
      most = rise;
      from = lowest;
      to = i;
    }
    if (value[i] + margin(i) < value[lowest] + margin(lowest)) lowest = i;
  }
  return change_between(levels, from, to, most);
}

/// Half the range of the residual of ln f with a share p.
double half_range(const Frequencies& levels, double share) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double left = levels.log[i] - share * levels.softening[i];
    low = std::min(low, left);
    high = std::max(high, left);
  }
  return 0.5 * (high - low);
}

/// The range is convex in p: its least by thirds.
double best_share(const Frequencies& levels) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 80; ++i) {
    const double third = (high - low) / 3.0;
    if (half_range(levels, low + third) <= half_range(levels, high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  const double found = 0.5 * (low + high);
  return half_range(levels, 0.0) <= half_range(levels, found) ? 0.0 : found;
}

/// The fall that exceeds the softening of one joint most.
FrequencyChange largest_fall(const Frequencies& levels) {
  std::vector<double> unexplained;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    unexplained.push_back(levels.softening[i] - levels.log[i]);
  }
  return largest_rise(levels, unexplained);
}

/// The same beyond each of several joints: of any two levels that one counts which softens most
/// between them.
FrequencyChange largest_fall(const std::vector<Frequencies>& joints) {
  const Frequencies& levels = joints.front();
  FrequencyChange worst;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t from = 0; from < levels.size(); ++from) {
    for (std::size_t to = from + 1; to < levels.size(); ++to) {
      double softest = 0.0;
      for (const Frequencies& joint : joints) {
        softest = std::min(softest, joint.softening[to] - joint.softening[from]);
      }
      const double margin = kSignificantChange * (levels.deviation[from] + levels.deviation[to]);
      const double excess = levels.log[from] - levels.log[to] + softest - margin;
      if (excess <= most) continue;
      most = excess;
      worst = change_between(levels, from, to, excess);
      worst.explained = std::expm1(softest);
    }
  }
  return worst;
}

/// The same beyond any joint that is possible: the softest over the fall found so far joins those
/// that explain it, and so on.
FrequencyChange unexplained_fall(const Levels& levels, const Frequencies& sorted,
                                 const SoftestJoint& softest) {
  FrequencyChange fall = largest_fall(sorted);
  if (!softest || sorted.size() > kMostForPairs) return fall;
  std::vector<Frequencies> joints{sorted};
  while (fall.significant && fall.from < fall.to && joints.size() <= kSofterJoints) {
    joints.emplace_back(levels, softest(fall.from, fall.to));
    fall = largest_fall(joints);
  }
  return fall;
}

std::optional<FrequencyEvidence> frequency_evidence(const Levels& levels, const Joint& joint,
                                                    const SoftestJoint& softest) {
  if (levels.frequency.empty() || levels.size() < 2) return std::nullopt;
  const Frequencies sorted(levels, joint);
  FrequencyEvidence evidence;
  evidence.rise = largest_rise(sorted, sorted.log);
  evidence.rise.explained = 0.0;
  evidence.fall = unexplained_fall(levels, sorted, softest);
  evidence.share = best_share(sorted);
  const double typical = std::exp(std::accumulate(sorted.log.begin(), sorted.log.end(), 0.0) /
                                  static_cast<double>(sorted.size()));
  evidence.uncertainty = typical * half_range(sorted, evidence.share);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double predicted = sorted.frequency.front() * std::exp(sorted.softening[i]);
    evidence.equivalent_joint_error =
        std::max(evidence.equivalent_joint_error, std::abs(sorted.frequency[i] - predicted));
  }
  return evidence;
}

std::string between(const FrequencyChange& change) {
  return fmt::format("from {:.4g} to {:.4g} µm ({:.5g} to {:.5g} Hz)", change.from / kMicrometre,
                     change.to / kMicrometre, change.from_frequency, change.to_frequency);
}

/// Consequence for predictions with this joint.
std::string consequence(const FrequencyEvidence& evidence) {
  return fmt::format(
      "A resonance predicted from this joint is uncertain by at least ± {:.2g} Hz, whatever the "
      "structure; where the joint provides all of its stiffness, by up to {:.2g} Hz.",
      evidence.uncertainty, evidence.equivalent_joint_error);
}

void diagnose_frequency(const FrequencyEvidence& evidence, std::vector<Warning>& warnings) {
  if (evidence.rise.significant) {
    warnings.push_back(
        {"frequency_rises",
         fmt::format("The frequency rises by {} {}, whereas a joint under constant normal load "
                     "only softens: this one explains the damping, not the stiffness. Levels of "
                     "different sessions, or a changed load, cause this. {}",
                     percent_text(evidence.rise.change), between(evidence.rise),
                     consequence(evidence))});
  }
  if (evidence.fall.significant) {
    warnings.push_back(
        {"softening_unexplained",
         fmt::format("The frequency falls by {} {}, of which the joint explains {} at most, even "
                     "if it provided all of the stiffness: something else softens, the load "
                     "changed between the levels, or k is wrong. {}",
                     percent_text(-evidence.fall.change), between(evidence.fall),
                     percent_text(-evidence.fall.explained), consequence(evidence))});
  }
}

}  // namespace

StiffnessEvidence stiffness_evidence(const LevelEvidence& levels, const Joint& joint,
                                     const SoftestJoint& softest) {
  return {.secant = secant_evidence(levels, joint),
          .frequency = frequency_evidence(levels.measured(), joint, softest)};
}

std::optional<Warning> diagnose_offset(const SecantEvidence& secant, double stiffness,
                                       double remainder) {
  const double offset = secant.offset;
  if (std::abs(offset) <= kMostOffset * stiffness) return std::nullopt;
  if (std::abs(offset) <= kSignificantOffset * secant.offset_std) return std::nullopt;
  std::string text = fmt::format(
      "The measured secant stiffnesses lie {:.3g} N/m ({} of k, ± {}) {} what D and k give: k = "
      "{:.4g} N/m would agree",
      std::abs(offset), percent_text(std::abs(offset) / stiffness),
      percent_text(secant.offset_std / stiffness), offset > 0.0 ? "above" : "below",
      stiffness + offset);
  // Below the lowest amplitude D determines only two moments of the density, not its area.
  const double other = remainder + offset / stiffness;
  if (offset < 0.0 && other >= 0.0) {
    text += fmt::format(
        ", or a further {} of k slips below the lowest amplitude, where D determines little: the "
        "elastic remainder is then {}, not {}",
        percent_text(-offset / stiffness), percent_text(other), percent_text(remainder));
  }
  text += fmt::format(". Resonances predicted from the joint are too {}.",
                      offset > 0.0 ? "low" : "high");
  return Warning{"secant_inconsistent", std::move(text)};
}

std::vector<Warning> diagnose(const StiffnessEvidence& evidence, const Joint& joint) {
  std::vector<Warning> warnings;
  if (evidence.secant) {
    if (auto offset = diagnose_offset(*evidence.secant, joint.stiffness(),
                                      joint.density().elastic_remainder())) {
      warnings.push_back(std::move(*offset));
    }
    const double scatter = evidence.secant->scatter.value_or(0.0);
    if (scatter > kMostScatter) {
      warnings.push_back(
          {"secant_misfit",
           fmt::format("The secant stiffness varies with amplitude differently from that of the "
                       "joint: with their mean removed, the two differ by {:.1f} times the "
                       "standard deviations given. Another density may fit both; the load changed "
                       "between the levels, or the standard deviations are too small.",
                       scatter)});
    }
  }
  if (evidence.frequency) diagnose_frequency(*evidence.frequency, warnings);
  return warnings;
}

}  // namespace microslip
