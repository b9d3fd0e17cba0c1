// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "microslip/base/percent.hpp"
#include "microslip/identify/evidence/masing_misfit.hpp"

namespace microslip {

std::string cause_text(const MasingMisfit& misfit, std::string_view quantity) {
  constexpr double kMicrometre = 1e-6;
  const std::string load = fmt::format("{} {}", percent_text(std::abs(misfit.size)),
                                       misfit.size < 0.0 ? "lower" : "higher");
  switch (misfit.cause) {
    case LevelCause::kStep:
      return fmt::format("as if the normal load were {} from {:.4g} µm on", load,
                         misfit.at / kMicrometre);
    case LevelCause::kTrend:
      return fmt::format("as if the normal load were {} at the largest level than at the smallest",
                         load);
    case LevelCause::kOrder:
      return fmt::format(
          "as if the normal load were {} at the last level measured than at the "
          "first",
          load);
    case LevelCause::kLinearDamping:
      return fmt::format("as if {} of D at the largest level were linear damping",
                         percent_text(misfit.size));
    case LevelCause::kLossFactor:
      return fmt::format("as if D were {:.2g} times that which {} requires", misfit.size, quantity);
    case LevelCause::kUnknown:
      break;
  }
  return fmt::format("most of all at {:.4g} µm", misfit.at / kMicrometre);
}

}  // namespace microslip
