// SPDX-License-Identifier: MIT
#include "microslip/calibrate/calibration_options.hpp"

#include <fmt/format.h>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr int kFewestCoefficients = 10;
constexpr std::size_t kFewestDraws = 100;

}  // namespace

std::string_view to_string(FrequencyUse use) {
  switch (use) {
    case FrequencyUse::kChange:
      return "change";
    case FrequencyUse::kAbsolute:
      return "absolute";
    case FrequencyUse::kIgnore:
      return "ignore";
  }
  return "";
}

void CalibrationOptions::check() const {
  if (coefficients < kFewestCoefficients) {
    throw InputError("coefficients", coefficients,
                     fmt::format("must be {} or more", kFewestCoefficients));
  }
  if (draws < kFewestDraws) {
    throw InputError("number of draws", static_cast<double>(draws),
                     fmt::format("must be {} or more", kFewestDraws), "1000 give smooth bands.");
  }
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw InputError("confidence", confidence, "must be between 0 and 1");
  }
  if (fit_stiffness && frequency != FrequencyUse::kAbsolute) {
    throw InputError("use of the frequencies", to_string(frequency),
                     "must be absolute to find stiffnesses: nothing else determines them",
                     "Take the stiffnesses as given, or the frequencies as absolute.");
  }
}

}  // namespace microslip
