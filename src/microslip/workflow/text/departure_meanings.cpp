// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/departure_meanings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace microslip {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kDepartures = {{
    {"rate_dependent", "the force follows the velocity"},
    {"asymmetric", "the two sides differ"},
    {"dead_zone", "play, pinching or bearing"},
    {"drifts", "the force grows or falls"},
    {"offset_drifts", "the zero of the force moves"},
    {"displacement_drifts", "the zero of the displacement moves"},
    {"not_masing", "loading and unloading differ in shape"},
    {"records_contradict", "the other records are of another joint"},
    {"order_matters", "rising and falling levels differ"},
    {"secant_against_dissipation", "k_eq does not soften as D implies"},
    {"frequency_against_dissipation", "the frequency does not fall as D implies"},
}};

}  // namespace

std::string departure_meaning(std::string_view code) {
  const auto* known =
      std::ranges::find(kDepartures, code, &std::pair<std::string_view, std::string_view>::first);
  return std::string(known == kDepartures.end() ? code : known->second);
}

std::string departure_with_code(std::string_view code) {
  const std::string meaning = departure_meaning(code);
  return meaning == code ? meaning : fmt::format("{} ({})", meaning, code);
}

}  // namespace microslip
