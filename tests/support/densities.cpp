// SPDX-License-Identifier: MIT
#include "support/densities.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace microslip::testing {

Joint joint_of(std::vector<DensityPart> parts) {
  return Joint(kStiffness, SlipDensity(std::move(parts)));
}

Joint sampled_joint(const std::function<double(double)>& shape, double to, double area) {
  constexpr int kKnots = 4000;
  PiecewiseLinearPart part;
  for (int i = 0; i <= kKnots; ++i) {
    const double share = static_cast<double>(std::max(i, 1)) / kKnots;  // shapes may end at 0
    part.slip_force.push_back(i == 0 ? 0.0 : to * share * share);
    part.density.push_back(shape(to * share * share));
  }
  double sum = 0.0;
  for (std::size_t i = 1; i < part.density.size(); ++i) {
    sum += 0.5 * (part.slip_force[i] - part.slip_force[i - 1]) *
           (part.density[i] + part.density[i - 1]);
  }
  for (double& value : part.density) value *= area / sum;
  return joint_of({part});
}

double bell(double x, double centre, double width) {
  const double u = (x - centre) / width;
  return std::exp(-0.5 * u * u);
}

Joint reference_joint() {
  const std::vector<double> force{0, 4, 8, 14, 20, 28, 36, 44, 52, 60, 75};
  std::vector<double> density{20, 17.5, 15, 12.5, 12.5, 15, 16.5, 15.5, 12, 8, 0};
  double area = 0.0;
  for (std::size_t i = 1; i < force.size(); ++i) {
    area += 0.5 * (force[i] - force[i - 1]) * (density[i] + density[i - 1]);
  }
  for (double& value : density) value /= area;
  return joint_of({PiecewiseLinearPart{force, density}});
}

Joint two_gaussians() {
  return sampled_joint([](double f) { return 0.6 * bell(f, 8, 2.5) + 0.4 * bell(f, 32, 5); }, 60,
                       0.9);
}

Joint two_lognormals() {
  const auto shape = [](double f) {
    return 0.5 * (bell(std::log(f / 6), 0, 0.4) + bell(std::log(f / 32), 0, 0.2)) / f;
  };
  return sampled_joint(shape, 75, 0.9);
}

Joint cut_power_law_and_bump() {
  const auto shape = [](double f) {
    return std::pow(f, -0.3) * std::exp(-f * f / 36) + 0.5 * bell(f, 30, 4);
  };
  return sampled_joint(shape, 60, 0.9);
}

Joint uniform_beyond_range() { return joint_of({UniformPart{0, 60, 1}}); }

Joint uniform_to_range_end() { return joint_of({UniformPart{0, kReach, 1}}); }

Joint power_law() { return joint_of({PowerLawPart{0.5 / std::sqrt(60.0), -0.5, 0, 60}}); }

Joint decaying_power_law() {
  return sampled_joint([](double f) { return std::pow(f, -0.3) * std::exp(-f / 30); }, 200, 0.95);
}

Joint gamma_density() {
  return sampled_joint([](double f) { return f * std::exp(-f / 9); }, 150, 0.85);
}

Joint ramp() { return joint_of({PiecewiseLinearPart{{0, 38}, {0, 2 * 0.8 / 38}}}); }

Joint faint_lognormal() {
  return sampled_joint([](double f) { return bell(std::log(f / 10), 0, 0.8) / f; }, 200, 0.12);
}

Joint power_law_and_three_bumps() {
  const auto shape = [](double f) {
    return std::pow(f, -0.7) + 0.25 * (bell(f, 9, 1.5) + bell(f, 21, 2) + bell(f, 40, 2.5));
  };
  return sampled_joint(shape, 70, 0.9);
}

std::vector<NamedJoint> unseen_truths() {
  return {{"gamma_density", gamma_density()},
          {"ramp", ramp()},
          {"faint_lognormal", faint_lognormal()},
          {"power_law_and_three_bumps", power_law_and_three_bumps()}};
}

std::vector<NamedJoint> all_truths() {
  return {{"reference", reference_joint()},
          {"two_gaussians", two_gaussians()},
          {"two_lognormals", two_lognormals()},
          {"cut_power_law_and_bump", cut_power_law_and_bump()},
          {"uniform_beyond_range", uniform_beyond_range()},
          {"uniform_to_range_end", uniform_to_range_end()},
          {"power_law", power_law()},
          {"decaying_power_law", decaying_power_law()}};
}

Levels levels_at(const Joint& joint, const std::vector<double>& amplitudes) {
  Levels levels;
  for (const double a : amplitudes) {
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(dissipation(joint, a));
  }
  return levels;
}

std::vector<double> equal_steps(std::size_t count, double from, double to) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return values;
}

std::vector<double> equal_ratios(std::size_t count, double from, double to) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return values;
}

Levels exact_levels(const Joint& joint) { return levels_at(joint, equal_steps(90)); }

void add_noise(Levels& levels, double relative, std::uint64_t draw) {
  RandomStream random(20260, draw);
  for (double& d : levels.dissipation) d *= 1.0 + relative * random.normal();
}

void add_secant(const Joint& joint, double relative, std::uint64_t draw, Levels& levels) {
  RandomStream random(20261, draw);
  levels.secant_stiffness.clear();
  for (const double a : levels.amplitude) {
    levels.secant_stiffness.push_back(secant_stiffness(joint, a) *
                                      (1.0 + relative * random.normal()));
  }
}

Levels noisy_levels(const Joint& joint, std::uint64_t draw, double relative) {
  Levels levels = exact_levels(joint);
  add_noise(levels, relative, draw);
  return levels;
}

double density_at(const std::vector<double>& slip_force, const std::vector<double>& density,
                  double f) {
  const auto next = std::ranges::upper_bound(slip_force, f);
  if (next == slip_force.begin()) return density.front();
  if (next == slip_force.end()) return f > slip_force.back() ? 0.0 : density.back();
  const auto i = static_cast<std::size_t>(next - slip_force.begin());
  const double share = (f - slip_force[i - 1]) / (slip_force[i] - slip_force[i - 1]);
  return density[i - 1] + share * (density[i] - density[i - 1]);
}

double density_error(const std::vector<double>& slip_force, const std::vector<double>& density,
                     const Joint& truth, double reach) {
  double square = 0.0;
  double scale = 0.0;
  for (int i = 0; i <= 2000; ++i) {
    const double f = reach * (0.05 + 0.9 * i / 2000);
    const double expected = truth.density().density(f);
    const double error = density_at(slip_force, density, f) - expected;
    square += error * error;
    scale += expected * expected;
  }
  return std::sqrt(square / scale);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

}  // namespace microslip::testing
