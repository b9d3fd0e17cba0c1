// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/axis_rank.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/recordings/assumed_units.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {
namespace {

/// Of spans of time, which are given over something else.
bool names_a_span(std::string_view name) {
  constexpr std::array kSpans{"DELAY", "LATENCY", "PERIOD", "DURATION",
                              "DECAY", "RISE",    "T60",    "TAU"};
  const std::string capitals = in_capitals(name);
  return std::ranges::any_of(
      kSpans, [&](const char* span) { return capitals.find(span) != std::string::npos; });
}

AxisRank rank_of_time(std::string_view name, const Unit& unit) {
  if (axis_dimension(name) == kTime) return AxisRank::kNamedTime;
  if (names_a_span(name)) return AxisRank::kSpan;
  if (unit.to_si(1.0) <= 1.0) return AxisRank::kTimeUnit;
  return is_named_as_time(name) ? AxisRank::kLongTime : AxisRank::kDoubtful;
}

AxisRank rank_of_frequency(std::string_view name, const Unit& unit) {
  if (quantity_of_name(name) == kFrequency || name == "f") return AxisRank::kNamedFrequency;
  return unit.to_si(1.0) < 1.0 ? AxisRank::kDoubtful : AxisRank::kFrequencyUnit;
}

}  // namespace

bool is_named_as_time(std::string_view name) {
  return quantity_of_name(name) == kTime || in_capitals(name).find("ELAPSED") != std::string::npos;
}

std::optional<AxisRank> rank_as_axis(std::string_view name, const Unit& unit) {
  if (unit.dimension == kTime) return rank_of_time(name, unit);
  if (unit.dimension == kFrequency) return rank_of_frequency(name, unit);
  return std::nullopt;
}

}  // namespace microslip
