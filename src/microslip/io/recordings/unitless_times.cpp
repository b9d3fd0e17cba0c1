// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/unitless_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace microslip {
namespace {

constexpr std::array kCounted{CountedUnit{"ns", "nanoseconds", 1e17},
                              CountedUnit{"us", "microseconds", 1e14},
                              CountedUnit{"ms", "milliseconds", 1e11}};
constexpr double kLongStep = 10.0;  // s, longer than those of a test
constexpr double kDecades = 100.0;  // from the least to the greatest of a unit

}  // namespace

const CountedUnit* counted_unit(double number) {
  const auto* const found = std::ranges::find_if(kCounted, [&](const CountedUnit& unit) {
    return number >= unit.least && number < kDecades * unit.least;
  });
  return found == kCounted.end() ? nullptr : found;
}

Warning since_1970(const CountedUnit& unit, const std::string& place) {
  return {"times_since_1970",
          fmt::format("{}: numbers without a unit, taken to be {} since 1970; times are given from "
                      "the first on. State the unit where it is another",
                      place, unit.words)};
}

std::optional<Warning> doubtful_seconds(double step, const std::string& place) {
  if (step < kLongStep) return std::nullopt;
  return Warning{"times_in_seconds",
                 fmt::format("{}: whole numbers without a unit, taken to be seconds, {} s from one "
                             "to the next. State the unit where it is another",
                             place, step)};
}

}  // namespace microslip
