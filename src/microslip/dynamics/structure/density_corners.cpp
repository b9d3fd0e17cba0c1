// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/density_corners.hpp"

#include <algorithm>
#include <numeric>
#include <variant>

namespace microslip {
namespace {

constexpr std::size_t kMostCorners = 16;
/// Of the weight of all atoms.
constexpr double kHeavy = 1.0 / 128.0;

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

std::vector<double> heavy_atoms(const SlipDensity& density) {
  const AtomsPart& atoms = density.atoms();
  const double all = std::accumulate(atoms.weight.begin(), atoms.weight.end(), 0.0);
  std::vector<double> heavy;
  for (std::size_t i = 0; i < atoms.weight.size(); ++i) {
    if (atoms.weight[i] > kHeavy * all) heavy.push_back(atoms.slip_force[i]);
  }
  return heavy;
}

bool has_many_atoms(const JointedStructure& structure) {
  return std::ranges::any_of(structure.joints(), [](const StructuralJoint& joint) {
    return joint.joint.density().atoms().slip_force.size() > kMostCorners;
  });
}

}  // namespace microslip
