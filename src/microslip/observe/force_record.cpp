// SPDX-License-Identifier: MIT
#include "microslip/observe/force_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_signal(std::string_view name, const std::vector<double>& values) {
  const auto wrong =
      std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
  if (wrong != values.end()) {
    throw InputError(fmt::format("{} of sample {}", name, wrong - values.begin() + 1), *wrong,
                     "must be finite");
  }
  const auto [low, high] = std::ranges::minmax(values);
  if (!(high > low)) {
    throw InputError(fmt::format("{} of the record", name), low,
                     "must vary: a joint at rest shows no slip",
                     "Give the channel that measures it.");
  }
}

}  // namespace

void check_force_record(const ForceRecord& record) {
  if (record.size() < kFewestRecordSamples) {
    throw InputError("number of samples", static_cast<double>(record.size()),
                     fmt::format("must be {} or more", kFewestRecordSamples),
                     "Record at least one cycle, with tens of samples.");
  }
  if (record.force.size() != record.size()) {
    throw InputError("number of forces", static_cast<double>(record.force.size()),
                     fmt::format("must be that of displacements, {}", record.size()));
  }
  if (!(record.time_step >= 0.0) || !std::isfinite(record.time_step)) {
    throw InputError("time step", record.time_step, "must be 0 or more, and finite");
  }
  check_signal("displacement", record.displacement);
  check_signal("force", record.force);
}

}  // namespace microslip
