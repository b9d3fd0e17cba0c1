// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/doubtful_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "microslip/io/bytes/text.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {

bool is_gravity(const Unit& unit) {
  return unit.dimension == kAcceleration && unit.factor() == kStandardGravity;
}

bool says_per_gravity(std::string_view text) {
  constexpr double kClose = 1e-3;  // 0.102 is 1/9.80665 to three digits
  constexpr std::string_view kStart = "0123456789.";
  for (;;) {
    text.remove_prefix(std::min(text.find_first_of(kStart), text.size()));
    if (text.empty()) return false;
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && std::abs(number * kStandardGravity - 1.0) < kClose) return true;
    // The rest of a number is none.
    text.remove_prefix(std::max<std::size_t>(1, static_cast<std::size_t>(end - text.data())));
  }
}

bool says_per_gravity(const Attributes& attributes) {
  return std::ranges::any_of(attributes, [](const auto& a) { return says_per_gravity(a.second); });
}

Warning doubtful_gravity(std::string_view place, std::string_view name,
                         std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return {
      "unit_doubtful",
      fmt::format("{}: channel {} is labelled g, but has the factor 0.10197 = 1/9.80665: its "
                  "values may already be in m/s^2. The largest is {:.4g} m/s^2 if so, {:.4g} m/s^2 "
                  "if in g; it is treated as without unit. Specify `assume_units {}=m/s^2` or {}=g",
                  place, in_quotes(name), largest, largest * kStandardGravity, name, name)};
}

bool is_force_in_pounds(std::string_view name, const Unit& unit) {
  const bool is_load =
      quantity_of_name(name) == kForce || in_capitals(name).find("LOAD") != std::string::npos;
  return is_load && unit.dimension == kMass && unit.factor() == parse_unit("lb", kMass).factor();
}

Warning force_in_pounds(std::string_view place, std::string_view name) {
  return {"unit_doubtful",
          fmt::format("{}: channel {} is in lb, a unit of mass, and named as a force; it is taken "
                      "in lbf. Write lbf",
                      place, in_quotes(name))};
}

Unit pound_force() { return parse_unit("lbf", kForce); }

}  // namespace microslip
