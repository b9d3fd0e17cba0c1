// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/shape_course.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace microslip {
namespace {

double interpolated(const std::vector<double>& places, const std::vector<double>& values,
                    double omega) {
  if (places.empty()) return 0.0;
  const double at = std::clamp(std::log(omega), places.front(), places.back());
  const auto after = std::ranges::upper_bound(places, at);
  if (after == places.end()) return values.back();
  const auto i = static_cast<std::size_t>(after - places.begin());
  const double share = (at - places[i - 1]) / (places[i] - places[i - 1]);
  return std::lerp(values[i - 1], values[i], share);
}

}  // namespace

double ShapeCourse::log_motion_at(double omega) const {
  return interpolated(log_omega, log_motion, omega);
}

double ShapeCourse::slope_at(double omega) const { return interpolated(log_omega, slope, omega); }

double ShapeCourse::slope_std_at(double omega) const {
  return interpolated(log_omega, slope_std, omega);
}

}  // namespace microslip
