// SPDX-License-Identifier: MIT
#include "microslip/dynamics/truncation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

constexpr std::size_t kMostPeaks = 20;
constexpr double kSeenShare = 1e-3;  // of the energy lost: what less means nobody sees

/// In resonance a lag says better than a frequency where a vibration is, which may move.
bool in_resonance(const SteadyVibration& point) { return std::sin(point.phase_lag) > 0.5; }

/// |F_n|/|F_1| of the two highest harmonics, of which symmetry may leave one out; largest of the
/// joints.
double top_harmonics(const SteadyVibration& point) {
  double most = 0.0;
  for (const JointCycle& joint : point.joints) {
    const std::size_t count = joint.force.size();
    for (std::size_t n = count < 4 ? 2 : count - 2; n < count; ++n) {
      if (joint.force[1] == 0.0) continue;
      most = std::max(most, std::abs(joint.force[n]) / std::abs(joint.force[1]));
    }
  }
  return most;
}

/// Which points of a curve are solved again.
struct Telling {
  std::vector<std::size_t> points;  ///< no two the same
  std::size_t peaks_left_out = 0;
};

class Selection {
 public:
  explicit Selection(const ResponseCurve& curve) : curve_(curve) {}

  void add(std::size_t i) {
    if (!holds(i)) points_.push_back(i);
  }

  /// Not where the curve turns back: what is kept does not determine such a point.
  template <typename Value>
  void add_largest(const Value& value) {
    std::optional<std::size_t> largest;
    for (std::size_t i = 0; i < curve_.points.size(); ++i) {
      if (std::ranges::find(curve_.turning_points, i) != curve_.turning_points.end()) continue;
      if (!largest || value(curve_.points[i]) > value(curve_.points[*largest])) largest = i;
    }
    if (largest) add(*largest);
  }

  [[nodiscard]] bool holds(std::size_t i) const {
    return std::ranges::find(points_, i) != points_.end();
  }
  [[nodiscard]] std::vector<std::size_t> points() const { return points_; }

 private:
  const ResponseCurve& curve_;
  std::vector<std::size_t> points_;
};

Telling telling(const ResponseCurve& curve) {
  Selection chosen(curve);
  chosen.add_largest([](const SteadyVibration& point) { return point.response; });
  for (std::size_t j = 0; j < curve.points.front().joints.size(); ++j) {
    chosen.add_largest([j](const SteadyVibration& point) { return point.joints[j].amplitude; });
  }
  chosen.add_largest([](const SteadyVibration& point) { return point.damping_ratio(); });
  chosen.add_largest(top_harmonics);
  std::vector<std::size_t> peaks;
  std::ranges::copy_if(curve.peak_points, std::back_inserter(peaks),
                       [&](std::size_t i) { return !chosen.holds(i); });
  std::ranges::stable_sort(peaks, std::ranges::greater{},
                           [&](std::size_t i) { return top_harmonics(curve.points[i]); });
  const std::size_t count = std::min(peaks.size(), kMostPeaks);
  for (std::size_t i = 0; i < count; ++i) chosen.add(peaks[i]);
  return {chosen.points(), peaks.size() - count};
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
  const Telling chosen = telling(curve);
  truncation.peaks_left_out = chosen.peaks_left_out;
  for (const std::size_t i : chosen.points) {
    const SteadyVibration& point = curve.points[i];
    const VibrationResult result = again(fine, point, kept);
    if (result.summary.converged()) {
      ++truncation.points;
      compare(point, result.vibration, kept, truncation);
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
