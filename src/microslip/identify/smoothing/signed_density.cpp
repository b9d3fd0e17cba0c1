// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/signed_density.hpp"

#include <cmath>

#include "microslip/base/error.hpp"

namespace microslip {

double density_from_curvature(double curvature, double amplitude, double stiffness) {
  return curvature / (4.0 * stiffness * stiffness * amplitude);
}

void check_stiffness(double stiffness) {
  if (!(std::isfinite(stiffness) && stiffness > 0.0)) {
    throw InputError("stiffness", stiffness, "must be positive and finite, in N/m",
                     "Take the stiffness of the stuck joint from a test at low level");
  }
}

}  // namespace microslip
