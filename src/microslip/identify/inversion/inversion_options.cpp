// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_options.hpp"

#include <cmath>

#include "microslip/base/error.hpp"

namespace microslip {

void InversionOptions::check() const {
  if (lambda && !(std::isfinite(*lambda) && *lambda > 0.0)) {
    throw InputError("lambda", *lambda, "must be positive and finite",
                     "Take one of the path that an automatic choice reports.");
  }
  if (coefficients < 10) throw InputError("coefficients", coefficients, "must be 10 or more");
  if (path_points < 5) {
    throw InputError("path_points", static_cast<double>(path_points), "must be 5 or more");
  }
}

}  // namespace microslip
