// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/whole_times.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/io/recordings/unitless_times.hpp"

namespace microslip {
namespace {

constexpr double kExact = 9007199254740992.0;  // 2⁵³, as doubles have 53 bits

/// Whether doubles hold times in seconds as finely as an axis must be even: to 1e-6 of a step.
bool holds_steps(double first, double step) {
  constexpr double kEvenTo = 1e-6;
  return std::abs(first) <= kExact && std::abs(first) <= kEvenTo * kExact * step;
}

}  // namespace

std::int64_t difference(std::int64_t later, std::int64_t earlier) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(later) -
                                   static_cast<std::uint64_t>(earlier));
}

WholeNumbers beyond_doubles(WholeNumbers numbers) {
  const bool is_beyond = std::ranges::any_of(numbers.bits, [&](std::int64_t bits) {
    return std::abs(static_cast<double>(bits)) > kExact;
  });
  return is_beyond ? std::move(numbers) : WholeNumbers{};
}

WholeTimes whole_times(const WholeNumbers& whole, const std::string& unit,
                       const std::string& place) {
  const std::vector<std::int64_t>& numbers = whole.bits;
  WholeTimes times{.values = {}, .unit = unit};
  if (numbers.empty()) return times;
  const auto first = static_cast<double>(numbers.front());
  const double step =
      numbers.size() < 2 ? 0.0 : std::abs(static_cast<double>(difference(numbers[1], numbers[0])));
  const bool is_beyond = !whole.is_signed && numbers.front() < 0;
  const CountedUnit* const counted = unit.empty() && !is_beyond ? counted_unit(first) : nullptr;
  if (counted != nullptr) {
    times.unit = counted->unit;
    times.warning = since_1970(*counted, place);
  }
  const bool from_first = counted != nullptr || is_beyond || !holds_steps(first, step);
  const std::int64_t zero = from_first ? numbers.front() : 0;
  times.values.reserve(numbers.size());
  for (const std::int64_t number : numbers) {
    times.values.push_back(static_cast<double>(difference(number, zero)));
  }
  return times;
}

}  // namespace microslip
