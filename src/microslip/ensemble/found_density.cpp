// SPDX-License-Identifier: MIT
#include "microslip/ensemble/found_density.hpp"

#include "microslip/base/interpolation.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip {
namespace {

std::vector<double> even(double from, double to, std::size_t count) {
  std::vector<double> values;
  const auto last = static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(from + (to - from) * static_cast<double>(i) / last);
  }
  return values;
}

/// φ, 1/N: linear between the knots, 0 beyond them, without the atom.
double density_at(const InversionResult& result, double slip_force) {
  const bool inside =
      slip_force >= result.slip_force.front() && slip_force <= result.slip_force.back();
  return inside ? interpolate(result.slip_force, result.density, slip_force) : 0.0;
}

}  // namespace

FoundDensity::FoundDensity(double stiffness, double lowest, double highest, std::size_t points,
                           bool linear_damping)
    : stiffness_(stiffness), linear_damping_(linear_damping) {
  outputs_.push_back({"area", kDimensionless});
  if (linear_damping) outputs_.push_back({"linear_damping", kEnergy / kLength.power(2)});
  outputs_.push_back(
      {"density", kPerForce, even(0.0, stiffness * highest, points), "slip_force", kForce});
  outputs_.push_back({"dissipation", kEnergy, even(lowest, highest, points), "amplitude", kLength});
}

std::vector<double> FoundDensity::of(const InversionResult& result) const {
  std::vector<double> values{result.area};
  if (linear_damping_) values.push_back(result.linear_damping.value_or(0.0));
  const Joint joint = joint_of(result, stiffness_);
  for (const EnsembleOutput& output : outputs_) {
    for (const double at : output.axis) {
      values.push_back(output.name == "density"
                           ? density_at(result, at)
                           : dissipation(joint, at) +
                                 result.linear_damping.value_or(0.0) * at * at);
    }
  }
  return values;
}

InversionOptions inversion_options(const PlannedIdentification& planned) {
  InversionOptions options;
  options.linear_damping = planned.linear_damping;
  options.atom = planned.atom;
  options.edges = planned.edges;
  return options;
}

}  // namespace microslip
