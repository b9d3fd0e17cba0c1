// SPDX-License-Identifier: MIT
#include "microslip/identify/methods/density_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"

namespace microslip {
namespace {

std::vector<double> points_of(double reach, CoveredRange range) {
  if (!(0.0 <= range.from && range.from < range.to && range.to <= 1.0)) {
    throw InputError("range", fmt::format("{} to {}", range.from, range.to),
                     "must rise, within 0 to 1");
  }
  if (!(std::isfinite(reach) && reach > 0.0)) {
    throw InputError("covered_to", reach, "must be above 0 N, and finite");
  }
  constexpr int kPoints = 2001;
  std::vector<double> points;
  for (int i = 0; i < kPoints; ++i) {
    const double share = range.from + (range.to - range.from) * i / (kPoints - 1);
    points.push_back(share * reach);
  }
  return points;
}

double relative_error(const std::function<double(double)>& density, double reach,
                      const SlipDensity& truth, CoveredRange range) {
  double difference = 0.0;
  double size = 0.0;
  for (const double f : points_of(reach, range)) {
    const double expected = truth.density(f);
    difference += std::pow(density(f) - expected, 2);
    size += expected * expected;
  }
  if (size == 0.0) throw InputError("truth", 0.0, "must have a density above 0 in the range");
  return std::sqrt(difference / size);
}

}  // namespace

double density_error(const Identification& found, const SlipDensity& truth, CoveredRange range) {
  return density_error(found.joint.density(), found.covered_to, truth, range);
}

double density_error(const SlipDensity& density, double reach, const SlipDensity& truth,
                     CoveredRange range) {
  return relative_error([&](double f) { return density.density(f); }, reach, truth, range);
}

double density_error(const std::vector<double>& slip_force, const std::vector<double>& density,
                     double reach, const SlipDensity& truth, CoveredRange range) {
  if (slip_force.empty() || slip_force.size() != density.size()) {
    throw InputError("density",
                     fmt::format("{} at {} slip forces", density.size(), slip_force.size()),
                     "must have one value per slip force, and at least one");
  }
  const auto between = [&](double f) { return interpolate(slip_force, density, f); };
  return relative_error(between, reach, truth, range);
}

double band_coverage(const Identification& found, const SlipDensity& truth, CoveredRange range) {
  if (found.lower.empty()) {
    throw InputError("found", "without band", "must have been identified with a band");
  }
  const std::size_t knots = found.slip_force.size();
  if (found.lower.size() != knots || found.upper.size() != knots) {
    throw InputError("band of found",
                     fmt::format("{} and {} values", found.lower.size(), found.upper.size()),
                     fmt::format("must have {}, one per slip force", knots));
  }
  const std::vector<double> points = points_of(found.covered_to, range);
  const auto inside = std::ranges::count_if(points, [&](double f) {
    const double expected = truth.density(f);
    return interpolate(found.slip_force, found.lower, f) <= expected &&
           expected <= interpolate(found.slip_force, found.upper, f);
  });
  return static_cast<double>(inside) / static_cast<double>(points.size());
}

}  // namespace microslip
