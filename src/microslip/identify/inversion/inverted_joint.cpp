// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inverted_joint.hpp"

#include <utility>

namespace microslip {
namespace {

Joint joint_with(const InversionResult& result, const std::vector<double>& density,
                 double atom_weight, double stiffness) {
  std::vector<DensityPart> parts{PiecewiseLinearPart{result.slip_force, density}};
  if (result.atom_slip_force && atom_weight > 0.0) {
    parts.emplace_back(AtomsPart{{*result.atom_slip_force}, {atom_weight}});
  }
  return Joint(stiffness, SlipDensity(std::move(parts)));
}

}  // namespace

Joint joint_of(const InversionResult& result, double stiffness) {
  return joint_with(result, result.density, result.atom_weight, stiffness);
}

std::vector<Joint> drawn_joints(const InversionResult& result,
                                std::span<const DensitySample> samples, double stiffness) {
  std::vector<Joint> joints;
  joints.reserve(samples.size());
  for (const DensitySample& sample : samples) {
    joints.push_back(joint_with(result, sample.density, sample.atom_weight, stiffness));
  }
  return joints;
}

}  // namespace microslip
