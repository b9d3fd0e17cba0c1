// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/stepped_sine_sweep.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_column(const SteppedSine& sweep, std::string_view name,
                  const std::vector<double>& values, bool positive) {
  if (values.size() != sweep.frequency.size()) {
    throw InputError(fmt::format("{}: {}", sweep.source, name),
                     fmt::format("{} values", values.size()),
                     fmt::format("must have {}, as the frequency", sweep.frequency.size()));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && (values[i] > 0.0 || !positive)) continue;
    throw InputError(fmt::format("{}: {} of step {}", sweep.source, name, i + 1), values[i],
                     positive ? "must be above 0 and finite" : "must be finite");
  }
}

}  // namespace

void check_stepped_sine(const SteppedSine& sweep) {
  if (sweep.frequency.size() < 2) {
    throw InputError(sweep.source, fmt::format("{} steps", sweep.frequency.size()),
                     "must have at least 2");
  }
  check_column(sweep, "frequency", sweep.frequency, true);
  check_column(sweep, "force", sweep.force, true);
  check_column(sweep, "acceleration", sweep.acceleration, true);
  check_column(sweep, "phase", sweep.phase, false);
}

}  // namespace microslip
