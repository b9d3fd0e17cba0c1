// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/target.hpp"

#include <fmt/format.h>

#include <numbers>

namespace microslip {

std::string_view to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::kAngularFrequency:
      return "angular frequency";
    case Quantity::kForceAmplitude:
      return "force amplitude";
    case Quantity::kResponse:
      return "response";
    case Quantity::kPhaseLag:
      break;
  }
  return "phase lag";
}

std::string describe(const Target& target, bool of_base) {
  switch (target.quantity) {
    case Quantity::kAngularFrequency:
      return fmt::format("frequency {:.9g} Hz", target.value / (2.0 * std::numbers::pi));
    case Quantity::kForceAmplitude:
      return of_base ? fmt::format("base acceleration {:.9g} m/s^2", target.value)
                     : fmt::format("force amplitude {:.9g} N", target.value);
    case Quantity::kPhaseLag:
      return fmt::format("phase lag {:.9g} rad", target.value);
    case Quantity::kResponse:
      break;
  }
  return fmt::format("response {:.9g}", target.value);
}

std::string drive_text(double amplitude, bool of_base) {
  return of_base ? fmt::format("base acceleration {:.6g} m/s^2", amplitude)
                 : fmt::format("force {:.6g} N", amplitude);
}

std::string_view unit_of(ResponseKind kind) {
  switch (kind) {
    case ResponseKind::kVelocity:
      return "m/s";
    case ResponseKind::kAcceleration:
      return "m/s^2";
    default:
      return "m";
  }
}

}  // namespace microslip
