// SPDX-License-Identifier: MIT
#include "microslip/dynamics/target.hpp"

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

}  // namespace microslip
