// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/turning_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace microslip {
namespace {

constexpr std::size_t kGridPerPeriod = 32;  // of the highest harmonic

/// Where the slope changes sign between a and b, by bisection to rounding: the slope costs so
/// little that nothing faster is needed.
double root_of_slope(const FourierSeries& slope, double a, double b) {
  const bool rising = slope.periodic_value(a) > 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (a + b);
    if (!(a < middle && middle < b)) break;
    ((slope.periodic_value(middle) > 0.0) == rising ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

}  // namespace

std::vector<TurningPoint> turning_points(const FourierSeries& series) {
  std::vector<TurningPoint> points;
  if (!(rms(series) > 0.0)) return points;
  const FourierSeries slope = derivative(series);
  const std::size_t cells = kGridPerPeriod * series.order();
  const double period = series.period();
  const double origin = slope.periodic_value(0.0);
  double before = origin;
  for (std::size_t i = 1; i <= cells; ++i) {
    const double a = period * static_cast<double>(i - 1) / static_cast<double>(cells);
    const double b = period * static_cast<double>(i) / static_cast<double>(cells);
    // The last point is the first: a change of sign must not be lost or found twice by rounding.
    const double here = i < cells ? slope.periodic_value(b) : origin;
    if ((before > 0.0) != (here > 0.0)) {
      const double time = root_of_slope(slope, a, b);
      points.push_back({time, series.periodic_value(time)});
    }
    before = here;
  }
  return points;
}

PeakToPeak peak_to_peak(const FourierSeries& series) {
  const std::vector<TurningPoint> points = turning_points(series);
  if (points.empty()) return {};
  const auto [low, high] = std::ranges::minmax_element(points, {}, &TurningPoint::value);
  return {.largest = high->value, .smallest = low->value};
}

}  // namespace microslip
