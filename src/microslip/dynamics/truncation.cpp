// SPDX-License-Identifier: MIT
#include "microslip/dynamics/truncation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

constexpr std::size_t kMostPoints = 5;
constexpr double kSeenShare = 1e-3;  // of the energy lost: what less means nobody sees

/// In resonance a lag says better than a frequency where a vibration is, which may move.
bool in_resonance(const SteadyVibration& point) { return std::sin(point.phase_lag) > 0.5; }

/// The most telling points, no two the same. Not those at which the curve turns back: what follows it
/// does not determine them.
std::vector<const SteadyVibration*> telling(const ResponseCurve& curve) {
  std::vector<const SteadyVibration*> points;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (std::ranges::find(curve.turning_points, i) != curve.turning_points.end()) continue;
    points.push_back(&curve.points[i]);
  }
  std::vector<const SteadyVibration*> result;
  const auto add = [&](const SteadyVibration* point) {
    const bool listed = std::ranges::find(result, point) != result.end();
    if (!listed && result.size() < kMostPoints) result.push_back(point);
  };
  const auto add_largest = [&](const auto& value) {
    const auto largest = std::ranges::max_element(
        points, {}, [&](const SteadyVibration* point) { return value(*point); });
    if (largest != points.end()) add(*largest);
  };
  add_largest([](const SteadyVibration& point) { return point.response; });
  for (const SteadyVibration& peak : curve.peaks) add(&peak);
  for (std::size_t j = 0; j < curve.points.front().joints.size(); ++j) {
    add_largest([j](const SteadyVibration& point) { return point.joints[j].amplitude; });
  }
  add_largest([](const SteadyVibration& point) { return point.damping_ratio(); });
  return result;
}

SteadyVibration padded(SteadyVibration vibration, std::size_t harmonics) {
  for (JointCycle& joint : vibration.joints) joint.displacement.resize(harmonics + 1);
  return vibration;
}

HarmonicBalance finer(const HarmonicBalance& balance, std::size_t harmonics) {
  HarmonicBalanceOptions options = balance.options();
  options.harmonics = harmonics;
  options.samples = std::max(options.samples, 4 * harmonics + 4);
  return {balance.structure(), balance.response(), options};
}

VibrationResult again(const HarmonicBalance& fine, const SteadyVibration& point, Quantity kept) {
  const SteadyVibration start = padded(point, fine.options().harmonics);
  if (kept == Quantity::kPhaseLag) {
    return fine.solve(kPhaseResonance, {Quantity::kResponse, point.response}, start);
  }
  const Target level{kept, kept == Quantity::kResponse ? point.response : point.force_amplitude};
  if (in_resonance(point)) {
    return fine.solve({Quantity::kPhaseLag, point.phase_lag}, level, start);
  }
  return fine.solve({Quantity::kAngularFrequency, point.angular_frequency}, level, start);
}

double change(double before, double after) {
  return after != 0.0 ? std::abs(before / after - 1.0) : 0.0;
}

void compare(const SteadyVibration& coarse, const SteadyVibration& fine, Quantity kept,
             Truncation& truncation) {
  const double level = kept == Quantity::kForceAmplitude
                           ? change(coarse.response, fine.response)
                           : change(coarse.force_amplitude, fine.force_amplitude);
  truncation.level = std::max(truncation.level, level);
  truncation.frequency =
      std::max(truncation.frequency, change(coarse.angular_frequency, fine.angular_frequency));
  double lost = fine.linear_dissipation;
  for (const JointCycle& joint : fine.joints) lost += joint.dissipation;
  for (std::size_t j = 0; j < fine.joints.size(); ++j) {
    if (!(fine.joints[j].dissipation > kSeenShare * lost)) continue;
    const double moved = change(coarse.joints[j].dissipation, fine.joints[j].dissipation);
    if (moved < truncation.dissipation) continue;
    truncation.dissipation = moved;
    truncation.joint = fine.joints[j].name;
    truncation.worst_response = fine.response;
    truncation.worst_frequency = fine.frequency();
  }
}

}  // namespace

double Truncation::largest() const { return std::max({dissipation, level, frequency}); }

std::optional<Truncation> judge_truncation(const HarmonicBalance& balance,
                                           const ResponseCurve& curve, Quantity kept) {
  if (curve.points.empty() || balance.structure().joints().empty()) return std::nullopt;
  Truncation truncation;
  truncation.harmonics = 2 * balance.options().harmonics + 1;
  truncation.response_unit = unit_of(balance.response().kind);
  const HarmonicBalance fine = finer(balance, truncation.harmonics);
  for (const SteadyVibration* point : telling(curve)) {
    const VibrationResult result = again(fine, *point, kept);
    if (result.summary.converged()) {
      ++truncation.points;
      compare(*point, result.vibration, kept, truncation);
    } else {
      truncation.unsolved = result.summary.reason;
    }
  }
  return truncation;
}

std::optional<Warning> truncation_warning(const Truncation& truncation) {
  if (truncation.largest() > kTruncationAllowed) {
    return Warning{
        "truncated",
        fmt::format(
            "with {0} harmonics the dissipation of '{1}' changes by {2:.2g} %, the level by "
            "{3:.2g} % and the frequency by {4:.2g} %, most at the response {5:.4g} {7}, "
            "{6:.6g} Hz: take {0} harmonics",
            truncation.harmonics, truncation.joint, 100.0 * truncation.dissipation,
            100.0 * truncation.level, 100.0 * truncation.frequency, truncation.worst_response,
            truncation.worst_frequency, truncation.response_unit)};
  }
  if (truncation.unsolved) {
    return Warning{"truncation_unknown",
                   fmt::format("whether the harmonics are enough was not seen everywhere: with {} "
                               "of them: {}",
                               truncation.harmonics, *truncation.unsolved)};
  }
  return std::nullopt;
}

}  // namespace microslip
