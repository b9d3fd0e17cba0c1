// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/density_corners.hpp"

#include <algorithm>
#include <variant>

namespace microslip {
namespace {

constexpr std::size_t kMostCorners = 16;

/// Where a part of a density jumps, but for s = 0.
struct Jumps {
  std::vector<double>& at;

  void operator()(const UniformPart& part) const { add(part.from, part.to); }
  void operator()(const PowerLawPart& part) const { add(part.from, part.to); }
  void operator()(const PiecewiseLinearPart& part) const {
    add(part.density.front() > 0.0 ? part.slip_force.front() : 0.0,
        part.density.back() > 0.0 ? part.slip_force.back() : 0.0);
  }
  void operator()(const AtomsPart&) const {}
  void operator()(const FourParameterPart& part) const {
    if (part.beta == 0.0) add(0.0, part.stiffness * macroslip_displacement(part));
  }

  void add(double from, double to) const {
    for (const double s : {from, to}) {
      if (s > 0.0) at.push_back(s);
    }
  }
};

}  // namespace

std::vector<Corner> corners_of(const SlipDensity& density) {
  std::vector<Corner> corners;
  if (density.atoms().slip_force.size() > kMostCorners) return corners;
  for (const double s : density.atoms().slip_force) corners.push_back({s, true});
  std::vector<double> jumps;
  for (const DensityPart& part : density.parts()) std::visit(Jumps{jumps}, part);
  if (jumps.size() + corners.size() <= kMostCorners) {
    for (const double s : jumps) corners.push_back({s, false});
  }
  std::ranges::stable_sort(corners, {}, &Corner::slip_force);
  return corners;
}

bool has_many_atoms(const JointedStructure& structure) {
  return std::ranges::any_of(structure.joints(), [](const StructuralJoint& joint) {
    return joint.joint.density().atoms().slip_force.size() > kMostCorners;
  });
}

}  // namespace microslip
