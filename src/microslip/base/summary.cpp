// SPDX-License-Identifier: MIT
#include "microslip/base/summary.hpp"

#include <fmt/format.h>

namespace microslip {

std::string_view Summary::status() const {
  if (stop == Stop::kNotRun) return "not run";
  return converged() ? kConvergedStatus : "not converged";
}

std::string Summary::brief() const {
  return fmt::format("{}: {} ({}), {} iterations, residual {:.1e}, {:.3g} ms", method, status(),
                     reason, iterations, residual, 1e3 * wall_seconds);
}

std::string Summary::full() const {
  std::string text = fmt::format(
      "method      {}\n"
      "status      {}\n"
      "reason      {}\n"
      "iterations  {}\n"
      "residual    {:.3e} (relative)\n"
      "wall time   {:.3g} ms\n",
      method, status(), reason, iterations, residual, 1e3 * wall_seconds);
  for (const Timing& timing : timings) {
    text += fmt::format("  {:.3g} ms  {}\n", 1e3 * timing.seconds, timing.what);
  }
  return text;
}

}  // namespace microslip
