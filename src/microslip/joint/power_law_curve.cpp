// SPDX-License-Identifier: MIT
#include "microslip/joint/power_law_curve.hpp"

namespace microslip {

PowerLawCurve::PowerLawCurve(const PowerLawPart& part)
    : part_(part),
      power_(part.from == 0.0 ? part.exponent + 1.0 : 0.0, part.to),
      weight_factor_(part.coefficient / (part.exponent + 1.0)),
      deficit_factor_(1.0 / (part.exponent + 2.0)),
      end_(part.from == 0.0 ? power_law_slip(part, part.to) : PowerLawSlip{}) {}

/// Beyond the end the weight stays, and the force falls behind by it.
PowerLawSlip PowerLawCurve::beside(double s) const {
  if (part_.from == 0.0 && s > part_.to) {
    return {end_.weight, end_.force_deficit + end_.weight * (s - part_.to)};
  }
  return power_law_slip(part_, s);
}

}  // namespace microslip
