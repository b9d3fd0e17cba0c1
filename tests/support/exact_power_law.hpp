// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "microslip/joint/density.hpp"

namespace microslip::testing {

using Exact = boost::multiprecision::cpp_bin_float_100;

/// The integrals of one power law by their textbook antiderivatives in 100 digits, of which the
/// cancellation costs less than half in any case that doubles can express.
class ExactPowerLaw {
 public:
  ExactPowerLaw(const PowerLawPart& part, double s)
      : part_(part), s_(s), to_(std::max(part.from, std::min(part.to, s))) {}

  /// ∫ f*ⁿ φ df* over [from, min(to, s)].
  [[nodiscard]] Exact moment(int n) const {
    const Exact p = Exact(part_.exponent) + n + 1;
    const Exact from = part_.from;
    if (p == 0) return part_.coefficient * log(to_ / from);
    const Exact at_from = part_.from == 0.0 ? Exact(0) : Exact(pow(from, p));
    return part_.coefficient * (pow(to_, p) - at_from) / p;
  }

  /// ∫ (s − f*) φ df*.
  [[nodiscard]] Exact force_deficit() const { return s_ * moment(0) - moment(1); }

  /// ∫ f*(s − f*) φ df*.
  [[nodiscard]] Exact slip_energy() const { return s_ * moment(1) - moment(2); }

 private:
  PowerLawPart part_;
  Exact s_;
  Exact to_;
};

inline double relative_error(double value, const Exact& exact) {
  return static_cast<double>(abs(Exact(value) / exact - 1));
}

}  // namespace microslip::testing
