// SPDX-License-Identifier: MIT
#include "microslip/joint/normal_load_scale.hpp"

#include <cmath>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

struct ScaledPart {
  double s;

  DensityPart operator()(UniformPart part) const {
    part.from *= s;
    part.to *= s;
    return part;
  }
  /// R f*^χ → R (f*/s)^χ/s.
  DensityPart operator()(PowerLawPart part) const {
    part.coefficient *= std::pow(s, -1.0 - part.exponent);
    part.from *= s;
    part.to *= s;
    return part;
  }
  DensityPart operator()(PiecewiseLinearPart part) const {
    for (double& f : part.slip_force) f *= s;
    for (double& phi : part.density) phi /= s;
    return part;
  }
  DensityPart operator()(AtomsPart part) const {
    for (double& f : part.slip_force) f *= s;
    return part;
  }
  DensityPart operator()(FourParameterPart part) const {
    part.macroslip_force *= s;
    return part;
  }
};

}  // namespace

Joint with_normal_load(const Joint& joint, double scale) {
  if (!(scale > 0.0 && std::isfinite(scale))) {
    throw InputError("scale of the normal load", scale, "must be positive and finite");
  }
  if (scale == 1.0) return joint;
  std::vector<DensityPart> parts;
  for (const DensityPart& part : joint.density().parts()) {
    parts.push_back(std::visit(ScaledPart{scale}, part));
  }
  return Joint(joint.stiffness(), SlipDensity(std::move(parts)));
}

}  // namespace microslip
