// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/curve_change.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <vector>

#include "microslip/dynamics/harmonic/nearby_solutions.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostPeaks = 20;
constexpr double kSeenShare = 1e-3;  // of the energy lost: less is negligible

/// In resonance a lag locates a vibration better than a frequency, which may shift.
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

  /// Not where the curve turns back: the constant quantity does not determine such a point.
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

void keep_resonances(const ResponseCurve& curve, std::vector<std::size_t>& points) {
  const auto off = [&](std::size_t i) { return !in_resonance(curve.points[i]); };
  if (!std::ranges::all_of(points, off)) std::erase_if(points, off);
}

SteadyVibration padded(SteadyVibration vibration, std::size_t harmonics) {
  for (JointCycle& joint : vibration.joints) joint.displacement.resize(harmonics + 1);
  return vibration;
}

NearbyTargets again(const SteadyVibration& point, std::size_t harmonics, Quantity kept) {
  const SteadyVibration start = padded(point, harmonics);
  if (kept == Quantity::kPhaseLag) {
    return {kPhaseResonance, {Quantity::kResponse, point.response}, start};
  }
  const Target level{kept, kept == Quantity::kResponse ? point.response : point.force_amplitude};
  if (in_resonance(point)) return {{Quantity::kPhaseLag, point.phase_lag}, level, start};
  return {{Quantity::kAngularFrequency, point.angular_frequency}, level, start};
}

double change(double before, double after) {
  return after != 0.0 ? std::abs(before / after - 1.0) : 0.0;
}

void compare(const SteadyVibration& before, const SteadyVibration& after, Quantity kept,
             CurveChange& curve_change) {
  const double level = kept == Quantity::kForceAmplitude
                           ? change(before.response, after.response)
                           : change(before.force_amplitude, after.force_amplitude);
  curve_change.level = std::max(curve_change.level, level);
  curve_change.frequency =
      std::max(curve_change.frequency, change(before.angular_frequency, after.angular_frequency));
  double lost = after.linear_dissipation;
  for (const JointCycle& joint : after.joints) lost += joint.dissipation;
  for (std::size_t j = 0; j < after.joints.size(); ++j) {
    if (!(after.joints[j].dissipation > kSeenShare * lost)) continue;
    const double moved = change(before.joints[j].dissipation, after.joints[j].dissipation);
    if (moved < curve_change.dissipation) continue;
    curve_change.dissipation = moved;
    curve_change.joint = after.joints[j].name;
    curve_change.worst_response = after.response;
    curve_change.worst_frequency = after.frequency();
  }
}

}  // namespace

double CurveChange::largest() const { return std::max({dissipation, level, frequency}); }

CurveChange solve_again(const HarmonicBalance& other, const ResponseCurve& curve, Quantity kept,
                        PointsAgain points) {
  CurveChange found;
  found.response_unit = unit_of(other.response().kind);
  if (curve.points.empty()) return found;
  Telling chosen = telling(curve);
  if (points == PointsAgain::kInResonance) keep_resonances(curve, chosen.points);
  found.peaks_left_out = chosen.peaks_left_out;
  std::vector<NearbyTargets> targets;
  for (const std::size_t i : chosen.points) {
    targets.push_back(again(curve.points[i], other.options().harmonics, kept));
  }
  const std::vector<VibrationResult> results =
      nearby_solutions(other.structure(), other.response(), other.options(), targets);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const VibrationResult& result = results[i];
    if (result.summary.converged()) {
      ++found.points;
      compare(curve.points[chosen.points[i]], result.vibration, kept, found);
    } else {
      found.unsolved = result.summary.reason;
    }
  }
  return found;
}

}  // namespace microslip
