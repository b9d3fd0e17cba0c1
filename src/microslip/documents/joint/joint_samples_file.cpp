// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/joint_samples_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// A draw may use more than its k by rounding.
constexpr double kMostOfStiffness = 1.0 + 1e-9;

void check_count(std::string_view name, std::size_t count, std::size_t expected) {
  if (count == expected) return;
  throw InputError(fmt::format("number of values of {}", name), static_cast<double>(count),
                   fmt::format("must be {}", expected));
}

void check_values(std::string_view name, std::span<const double> values, double least,
                  std::string_view rule) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && values[i] >= least) continue;
    throw InputError(fmt::format("{}[{}]", name, i), values[i], rule);
  }
}

constexpr std::string_view kNotNegative = "must be 0 or more, and finite";
constexpr double kSmallest = 1e-300;

void check_slip_displacement(const std::vector<double>& points) {
  if (points.size() < 2) {
    throw InputError("number of values of slip_displacement", static_cast<double>(points.size()),
                     "must be 2 or more");
  }
  check_values("slip_displacement", points, 0.0, kNotNegative);
  for (std::size_t j = 1; j < points.size(); ++j) {
    if (points[j] > points[j - 1]) continue;
    throw InputError(fmt::format("slip_displacement[{}]", j), points[j],
                     "must be above the value before it");
  }
}

/// Share of k that a draw lets slip within its points.
double slipping_share(const JointSamples& samples, std::size_t draw) {
  const std::vector<double>& x = samples.slip_displacement;
  const double* psi = samples.stiffness_density.data() + draw * x.size();
  double sum = 0.0;
  for (std::size_t j = 1; j < x.size(); ++j) sum += 0.5 * (x[j] - x[j - 1]) * (psi[j] + psi[j - 1]);
  const double atom = samples.atom_weight.empty() ? 0.0 : samples.atom_weight[draw];
  return sum / samples.stiffness[draw] + atom;
}

}  // namespace

void JointSamples::check() const {
  if (size() == 0) throw InputError("number of draws", 0.0, "must be 1 or more");
  check_slip_displacement(slip_displacement);
  check_count("stiffness_density", stiffness_density.size(), size() * slip_displacement.size());
  check_values("stiffness_density", stiffness_density, 0.0, kNotNegative);
  check_values("stiffness", stiffness, kSmallest, "must be above 0, and finite");
  check_count("atom_weight", atom_weight.size(), atom_slip_displacement ? size() : 0);
  check_values("atom_weight", atom_weight, 0.0, kNotNegative);
  if (atom_slip_displacement) {
    check_values("atom_slip_displacement", {&*atom_slip_displacement, 1}, kSmallest,
                 "must be above 0, and finite");
  }
  for (const auto& [name, values] :
       {std::pair{"linear_damping", &linear_damping}, std::pair{"viscous", &viscous}}) {
    if (!values->empty()) check_count(name, values->size(), size());
    check_values(name, *values, 0.0, kNotNegative);
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const double share = slipping_share(*this, i);
    if (share <= kMostOfStiffness) continue;
    throw InputError(fmt::format("slipping fraction of k in draw {}", i), share,
                     "must not be above 1");
  }
}

Joint JointSamples::joint(std::size_t i) const {
  if (i >= size()) {
    throw InputError("number of a draw", static_cast<double>(i),
                     fmt::format("must be from 0 to {}", static_cast<double>(size()) - 1.0));
  }
  const double k = stiffness[i];
  // An excess over k by rounding is removed.
  const double more = std::max(1.0, slipping_share(*this, i));
  PiecewiseLinearPart part;
  for (std::size_t j = 0; j < slip_displacement.size(); ++j) {
    part.slip_force.push_back(k * slip_displacement[j]);
    part.density.push_back(stiffness_density[i * slip_displacement.size() + j] / (k * k * more));
  }
  std::vector<DensityPart> parts{std::move(part)};
  if (atom_slip_displacement && atom_weight[i] > 0.0) {
    parts.emplace_back(AtomsPart{{k * *atom_slip_displacement}, {atom_weight[i] / more}});
  }
  return Joint(k, SlipDensity(std::move(parts)));
}

}  // namespace microslip
