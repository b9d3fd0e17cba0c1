// SPDX-License-Identifier: MIT
#include "microslip/base/summary.hpp"

#include <fmt/format.h>

namespace microslip {

std::string_view to_string(Status status) {
  switch (status) {
    case Status::kConverged:
      return "converged";
    case Status::kNotConverged:
      return "not converged";
    case Status::kNotRun:
      break;
  }
  return "not run";
}

std::string Summary::brief() const {
  return fmt::format("{}: {} ({}), {} iterations, residual {:.1e}, {:.3g} ms", method,
                     to_string(status), reason, iterations, residual, 1e3 * wall_seconds);
}

std::string Summary::full() const {
  return fmt::format(
      "method      {}\n"
      "status      {}\n"
      "reason      {}\n"
      "iterations  {}\n"
      "residual    {:.3e} (relative)\n"
      "wall time   {:.3g} ms\n",
      method, to_string(status), reason, iterations, residual, 1e3 * wall_seconds);
}

}  // namespace microslip
