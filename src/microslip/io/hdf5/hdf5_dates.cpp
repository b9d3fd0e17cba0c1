// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_dates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip {
namespace {

/// What whole numbers since 1970 count, from 1973 to 2286.
struct CountedUnit {
  const char* unit;
  const char* words;
  double least;
};

constexpr std::array kCounted{CountedUnit{"ns", "nanoseconds", 1e17},
                              CountedUnit{"us", "microseconds", 1e14},
                              CountedUnit{"ms", "milliseconds", 1e11}};
constexpr double kLongStep = 10.0;  // s, longer than those of a test
constexpr double kDecades = 100.0;  // from the least to the greatest of a unit

const CountedUnit* counted_unit(double number) {
  const auto* const found = std::ranges::find_if(kCounted, [&](const CountedUnit& unit) {
    return number >= unit.least && number < kDecades * unit.least;
  });
  return found == kCounted.end() ? nullptr : found;
}

/// Whether doubles, which have 53 bits, hold times in seconds as finely as an axis must be even: to
/// 1e-6 of a step.
bool holds_steps(double first, double step) {
  constexpr double kExact = 9007199254740992.0;  // 2⁵³
  constexpr double kEvenTo = 1e-6;
  return std::abs(first) <= kExact && std::abs(first) <= kEvenTo * kExact * step;
}

/// Numbers without a unit are taken for seconds, which they may not be.
std::optional<Warning> doubtful_seconds(double step, const std::string& place) {
  if (step < kLongStep) return std::nullopt;
  return Warning{"times_in_seconds",
                 fmt::format("{}: whole numbers without a unit, taken to be seconds, {} s from one "
                             "to the next. State the unit where it is another",
                             place, step)};
}

}  // namespace

std::int64_t difference(std::int64_t later, std::int64_t earlier) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(later) -
                                   static_cast<std::uint64_t>(earlier));
}

bool is_large_integer(hid_t type) {
  return H5Tget_class(type) == H5T_INTEGER && H5Tget_size(type) == sizeof(std::int64_t);
}

WholeTimes whole_times(std::span<const std::int64_t> numbers, const std::string& unit,
                       const std::string& place) {
  WholeTimes times{.values = {}, .unit = unit};
  if (numbers.empty()) return times;
  const auto first = static_cast<double>(numbers.front());
  const double step =
      numbers.size() < 2 ? 0.0 : std::abs(static_cast<double>(difference(numbers[1], numbers[0])));
  const CountedUnit* const counted = unit.empty() ? counted_unit(first) : nullptr;
  if (counted != nullptr) {
    times.unit = counted->unit;
    times.warning = Warning{
        "times_since_1970",
        fmt::format("{}: whole numbers without a unit, taken to be {} since 1970; times are given "
                    "from the first on. State the unit where it is another",
                    place, counted->words)};
  } else if (unit.empty()) {
    times.warning = doubtful_seconds(step, place);
  }
  const bool from_first = counted != nullptr || !holds_steps(first, step);
  const std::int64_t zero = from_first ? numbers.front() : 0;
  times.values.reserve(numbers.size());
  for (const std::int64_t number : numbers) {
    times.values.push_back(static_cast<double>(difference(number, zero)));
  }
  return times;
}

}  // namespace microslip
