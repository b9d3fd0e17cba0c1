// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/differences.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// The factors of D_{i−1}, D_i, D_{i+1} in D″_i.
std::array<double, 3> second_difference(double left, double right) {
  const double sum = left + right;
  return {2.0 / (left * sum), -2.0 / (left * right), 2.0 / (right * sum)};
}

}  // namespace

SignedDensity density_by_differences(const LevelEvidence& levels, double stiffness) {
  check_stiffness(stiffness);
  const Levels& merged = levels.levels();
  const auto& a = merged.amplitude;
  const auto& d = merged.dissipation;
  const auto& sigma = merged.dissipation_std;
  if (a.size() < 3) {
    throw InputError("number of distinct amplitudes", static_cast<double>(a.size()),
                     "must be at least 3 for second differences", "Measure more levels");
  }
  SignedDensity result;
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    const auto c = second_difference(a[i] - a[i - 1], a[i + 1] - a[i]);
    // Through the differences of D, which lose less to rounding than D times the factors.
    const double curvature = c[2] * (d[i + 1] - d[i]) - c[0] * (d[i] - d[i - 1]);
    result.slip_force.push_back(stiffness * a[i]);
    result.density.push_back(density_from_curvature(curvature, a[i], stiffness));
    if (sigma.empty()) continue;
    const double noise = std::hypot(c[0] * sigma[i - 1], c[1] * sigma[i], c[2] * sigma[i + 1]);
    result.standard_deviation.push_back(density_from_curvature(noise, a[i], stiffness));
  }
  return result;
}

}  // namespace microslip
