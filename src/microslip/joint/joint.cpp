// SPDX-License-Identifier: MIT
#include "microslip/joint/joint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

double checked_stiffness(double stiffness, const SlipDensity& density) {
  if (!(std::isfinite(stiffness) && stiffness > 0.0)) {
    throw InputError("stiffness", stiffness, "must be positive and finite, in N/m");
  }
  for (const DensityPart& part : density.parts()) {
    const auto* four = std::get_if<FourParameterPart>(&part);
    if (four != nullptr && four->stiffness != stiffness) {
      throw InputError(
          "stiffness", stiffness,
          fmt::format("must equal K_T = {} of its four-parameter density", four->stiffness));
    }
  }
  return stiffness;
}

}  // namespace

Joint::Joint(double stiffness, SlipDensity density)
    : stiffness_(checked_stiffness(stiffness, density)),
      density_(std::move(density)),
      virgin_curve_(density_) {}

Joint Joint::four_parameter(double macroslip_force, double stiffness, double chi, double beta) {
  return Joint(stiffness, SlipDensity({FourParameterPart{macroslip_force, stiffness, chi, beta}}));
}

double Joint::virgin_force(double x) const {
  const double s = stiffness_ * std::abs(x);
  if (!std::isinf(s)) [[likely]]
    return std::copysign(virgin_curve_.force(s), x);
  return std::copysign(density_.elastic_remainder() > 0.0 ? s : macroslip_force(), x);
}

double Joint::tangent_stiffness(double x) const {
  const double s = stiffness_ * std::abs(x);
  if (!std::isinf(s)) [[likely]]
    return stiffness_ * virgin_curve_.slope(s);
  return stiffness_ * density_.elastic_remainder();
}

double Joint::macroslip_displacement() const {
  if (density_.elastic_remainder() > 0.0) return std::numeric_limits<double>::infinity();
  return density_.largest_slip_force() / stiffness_;
}

}  // namespace microslip
