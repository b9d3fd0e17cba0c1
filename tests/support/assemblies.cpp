// SPDX-License-Identifier: MIT
#include "support/assemblies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace microslip::testing {

Joint assembly_of(const Joint& middle, const KnownSpread& spread, std::uint64_t seed,
                  std::uint64_t number) {
  constexpr std::size_t kKnots = 1500;
  RandomStream random(seed, number);
  const double k = middle.stiffness() * std::exp(spread.stiffness * random.normal());
  const double scale = std::exp(spread.slip_force * random.normal());
  const double each = spread.shape / std::sqrt(2.0);
  const double constant = each * random.normal();
  const double cosine = each * random.normal();
  const double sine = each * random.normal();
  const double end = middle.density().largest_slip_force();
  PiecewiseLinearPart part;
  for (std::size_t i = 0; i <= kKnots; ++i) {
    const double t = static_cast<double>(i) / kKnots;
    const double f = end * std::max(t * t, 1e-8) * (i == kKnots ? 1.0 - 1e-12 : 1.0);
    const double g =
        constant + cosine * std::cos(std::numbers::pi * t) + sine * std::sin(std::numbers::pi * t);
    part.slip_force.push_back(i == 0 ? 0.0 : scale * f);
    part.density.push_back(middle.density().density(f) / scale * std::exp(g));
  }
  const double area = integral(part.slip_force, part.density);
  for (double& value : part.density) value /= std::max(1.0, area);
  return {k, SlipDensity({part})};
}

Levels measured_levels(const Joint& joint, std::size_t count, double scatter, std::uint64_t seed,
                       std::uint64_t number) {
  Levels levels =
      levels_at(joint, equal_ratios(count, 0.03 * kLargestAmplitude, kLargestAmplitude));
  RandomStream random(seed, 1000 + number);
  for (double& d : levels.dissipation) d *= 1.0 + scatter * random.normal();
  return levels;
}

std::vector<Assembly> measured_assemblies(const Joint& middle, const KnownSpread& spread,
                                          std::size_t count, std::uint64_t seed, std::size_t levels,
                                          double scatter) {
  std::vector<Assembly> all;
  for (std::size_t j = 0; j < count; ++j) {
    const Joint joint = assembly_of(middle, spread, seed, j);
    all.push_back({std::string(1, static_cast<char>('a' + j)),
                   LevelEvidence(measured_levels(joint, levels, scatter, seed, j)),
                   joint.stiffness()});
  }
  return all;
}

}  // namespace microslip::testing
