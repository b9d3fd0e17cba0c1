// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/curve_heights.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace microslip {
namespace {

/// The cubic from `a` to `b` with slopes `da` and `db` over a unit step, at t in [0, 1].
template <typename Value>
Value cubic(Value a, Value da, Value b, Value db, double t) {
  const double r = 1.0 - t;
  return a * (r * r * (1.0 + 2.0 * t)) + b * (t * t * (1.0 + 2.0 * r)) + da * (t * r * r) -
         db * (t * t * r);
}

/// Slope of the parabola through three points, at the middle one.
template <typename Value>
Value middle_slope(double before, Value rise_before, double after, Value rise_after) {
  return (rise_before / before * after + rise_after / after * before) / (before + after);
}

/// Slopes between which a cubic is monotone. [Fritsch & Carlson, SIAM J. Numer. Anal. 17 (1980)]
double monotone(double slope, double before, double after) {
  constexpr double kMost = 3.0;
  if (before * after <= 0.0) return 0.0;
  const double most = kMost * std::min(std::abs(before), std::abs(after));
  return std::clamp(slope, -most, most);
}

}  // namespace

double height_of(const SteadyVibration& point, Quantity kept) {
  return kept == Quantity::kForceAmplitude ? point.response : point.force_amplitude;
}

CurveHeights::CurveHeights(const ResponseCurve& curve, Quantity kept) {
  for (const SteadyVibration& point : curve.points) {
    const double height = height_of(point, kept);
    if (!std::isfinite(height) || !std::isfinite(point.angular_frequency)) continue;
    nodes_.push_back({point.angular_frequency, std::polar(height, -point.phase_lag)});
  }
  add_places();
  add_slopes();
}

/// Both parts of the length relative: a step changes the height by a share of itself.
void CurveHeights::add_places() {
  if (nodes_.empty()) return;
  const auto [least, most] = std::ranges::minmax(nodes_, {}, &Node::angular_frequency);
  const double range = most.angular_frequency - least.angular_frequency;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const Node& a = nodes_[i - 1];
    Node& b = nodes_[i];
    const double size = std::max(std::abs(a.height), std::abs(b.height));
    const double turned = size > 0.0 ? std::abs(b.height - a.height) / size : 0.0;
    const double gone =
        range > 0.0 ? std::abs(b.angular_frequency - a.angular_frequency) / range : 0.0;
    // Two points at one place have no length between them.
    b.place = a.place + std::max(std::hypot(turned, gone), 1e-300);
  }
}

void CurveHeights::add_slopes() {
  const auto rise = [&](std::size_t i) {  // from i to i + 1
    return std::pair{
        (nodes_[i + 1].angular_frequency - nodes_[i].angular_frequency) /
            (nodes_[i + 1].place - nodes_[i].place),
        (nodes_[i + 1].height - nodes_[i].height) / (nodes_[i + 1].place - nodes_[i].place)};
  };
  if (nodes_.size() < 2) return;
  std::tie(nodes_.front().slope, nodes_.front().height_slope) = rise(0);
  std::tie(nodes_.back().slope, nodes_.back().height_slope) = rise(nodes_.size() - 2);
  for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
    const double before = nodes_[i].place - nodes_[i - 1].place;
    const double after = nodes_[i + 1].place - nodes_[i].place;
    const auto [slope_before, height_before] = rise(i - 1);
    const auto [slope_after, height_after] = rise(i);
    nodes_[i].slope =
        monotone(middle_slope(before, slope_before * before, after, slope_after * after),
                 slope_before, slope_after);
    nodes_[i].height_slope =
        middle_slope(before, height_before * before, after, height_after * after);
  }
}

double CurveHeights::height_in(const Node& from, const Node& to, double angular_frequency) const {
  constexpr int kHalvings = 50;
  const double length = to.place - from.place;
  const auto omega_at = [&](double t) {
    return cubic(from.angular_frequency, length * from.slope, to.angular_frequency,
                 length * to.slope, t);
  };
  const bool rising = to.angular_frequency > from.angular_frequency;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    ((omega_at(middle) < angular_frequency) == rising ? low : high) = middle;
  }
  return std::abs(cubic(from.height, length * from.height_slope, to.height,
                        length * to.height_slope, 0.5 * (low + high)));
}

std::vector<double> CurveHeights::at(double angular_frequency) const {
  // The ends of a range are met to rounding.
  constexpr double kRounding = 1e-9;
  std::vector<double> heights;
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    const double a = nodes_[i].angular_frequency;
    const double b = nodes_[i + 1].angular_frequency;
    // A point belongs to the piece that begins there, so that it counts once, and where the curve
    // turns back once, too.
    const bool within = a < b ? a <= angular_frequency && angular_frequency < b
                              : b < angular_frequency && angular_frequency <= a;
    if (within) heights.push_back(height_in(nodes_[i], nodes_[i + 1], angular_frequency));
  }
  for (const Node* end :
       {nodes_.empty() ? nullptr : &nodes_.front(), nodes_.empty() ? nullptr : &nodes_.back()}) {
    if (!heights.empty() || end == nullptr) continue;
    if (std::abs(end->angular_frequency - angular_frequency) <= kRounding * angular_frequency) {
      heights.push_back(std::abs(end->height));
    }
  }
  std::ranges::sort(heights);
  return heights;
}

}  // namespace microslip
