// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/density.hpp"
#include "microslip/joint/fixed_power.hpp"
#include "microslip/joint/power_law.hpp"

namespace microslip {

/// power_law_slip() of one power law at many s: where it begins at 0, from a table of the power.
/// Internal to joint.
class PowerLawCurve {
 public:
  /// @param part  as in a density.
  explicit PowerLawCurve(const PowerLawPart& part);

  /// Φ0(s) and ∫ (s − f*) φ df*. @param s  N; ≥ 0, finite.
  [[nodiscard]] PowerLawSlip slip(double s) const {
    if (power_.covers(s)) {
      const double weight = weight_factor_ * power_(s);
      return {weight, deficit_factor_ * (weight * s)};
    }
    return beside(s);
  }
  /// Φ0(s) alone, which is cheaper where the law begins above 0.
  [[nodiscard]] double weight(double s) const {
    return power_.covers(s) ? weight_factor_ * power_(s) : power_law_weight(part_, s);
  }
  [[nodiscard]] double force_deficit(double s) const {  ///< alone, cheaper as well
    return part_.from == 0.0 ? slip(s).force_deficit : power_law_force_deficit(part_, s);
  }

 private:
  [[nodiscard]] PowerLawSlip beside(double s) const;

  PowerLawPart part_;
  FixedPower power_;       // s^(χ + 1); empty where the law begins above 0
  double weight_factor_;   // R/(χ + 1)
  double deficit_factor_;  // 1/(χ + 2)
  PowerLawSlip end_;       // at `to`, of such a table
};

}  // namespace microslip
