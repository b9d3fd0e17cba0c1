// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assemblies_result.hpp"

#include <algorithm>
#include <utility>

#include "microslip/base/interpolation.hpp"

namespace microslip {
namespace {

Joint joint_up_to(double stiffness, const std::vector<double>& slip_force,
                  const std::vector<double>& density, double top) {
  constexpr double kBelow = 1.0 - 1e-9;  // a knot there would be the last one
  const double end = std::min(top, slip_force.back());
  PiecewiseLinearPart part;
  for (std::size_t i = 0; slip_force[i] < kBelow * end; ++i) {
    part.slip_force.push_back(slip_force[i]);
    part.density.push_back(density[i]);
  }
  part.slip_force.push_back(end);
  part.density.push_back(interpolate(slip_force, density, end));
  return {stiffness, SlipDensity({std::move(part)})};
}

}  // namespace

Joint AssembliesResult::joint() const {
  return joint_up_to(stiffness, slip_force, common.density, covered_to);
}

Joint AssembliesResult::joint(std::size_t assembly) const {
  const AssemblyFit& fit = assemblies.at(assembly);
  return joint_up_to(fit.stiffness.value, slip_force, fit.density.density, fit.covered_to);
}

}  // namespace microslip
