// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

constexpr std::uint64_t kMostValues = 10'000'000;

/// A number and the unit behind it, SI where there is none.
struct GivenQuantity {
  double value = 0.0;
  Unit unit;

  [[nodiscard]] double si() const { return unit.to_si(value); }
  [[nodiscard]] bool has_unit_of(const GivenQuantity& other) const {
    return unit.numerator == other.unit.numerator && unit.denominator == other.unit.denominator;
  }
};

/// Longer texts are no number with a unit that was written in another country.
constexpr std::size_t kLongestSuggestion = 40;

/// Behind the whole part of a number.
bool has_decimal_comma(std::string_view rest) {
  return rest.size() > 1 && rest[0] == ',' && rest[1] >= '0' && rest[1] <= '9';
}

GivenQuantity read_quantity(std::string_view option, std::string_view text,
                            const Dimension& dimension) {
  std::string_view rest = trimmed(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) {
    throw InputError(option, in_quotes(text),
                     dimension == kDimensionless
                         ? "must be a finite number"
                         : fmt::format("must be a finite number, in {} or with a unit after it",
                                       si_unit(dimension)));
  }
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (has_decimal_comma(rest)) {
    std::string point(text.substr(0, kLongestSuggestion));
    std::ranges::replace(point, ',', '.');
    throw InputError(option, in_quotes(text), "must have a decimal point",
                     text.size() > kLongestSuggestion
                         ? "Write a decimal point instead of the comma."
                         : fmt::format("Write {}.", point));
  }
  rest = trimmed(rest);
  if (rest.empty()) return {value, {.dimension = dimension}};
  return {value, parse_option_unit(option, rest, dimension)};
}

std::pair<double, double> read_ends(std::string_view option, std::string_view text,
                                    const Dimension& dimension) {
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() != 2) {
    throw InputError(option, in_quotes(text), "must read FROM:TO",
                     "Write the two numbers with a colon between, e.g. 50:60.");
  }
  return {parse_quantity(fmt::format("FROM of {}", option), parts[0], dimension),
          parse_quantity(fmt::format("TO of {}", option), parts[1], dimension)};
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double parse_quantity(std::string_view option, std::string_view text, const Dimension& dimension) {
  return read_quantity(option, text, dimension).si();
}

bool is_quantity(std::string_view text, const Dimension& dimension) {
  try {
    const bool has_unit = text.find_first_not_of("0123456789.eE+- ") != std::string_view::npos;
    (void)parse_quantity("", text, dimension);
    return has_unit;
  } catch (const InputError&) {
    return false;
  }
}

Unit parse_option_unit(std::string_view option, std::string_view text, const Dimension& dimension) {
  try {
    return parse_unit(text, dimension);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", option, error.name()));
  }
}

std::uint64_t parse_whole_number(std::string_view option, std::string_view text, std::uint64_t from,
                                 std::uint64_t to, std::string_view remedy) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < from || value > to) {
    throw InputError(option, in_quotes(text),
                     fmt::format("must be a whole number in digits, from {} to {}", from, to),
                     remedy);
  }
  return value;
}

std::pair<double, double> parse_interval(std::string_view option, std::string_view text,
                                         const Dimension& dimension) {
  const auto [from, to] = read_ends(option, text, dimension);
  if (from < to) return {from, to};
  throw InputError(option, in_quotes(text), "FROM must be below TO", "Swap the two.");
}

std::pair<double, double> parse_ends(std::string_view option, std::string_view text,
                                     const Dimension& dimension) {
  const auto [from, to] = read_ends(option, text, dimension);
  if (from != to) return {from, to};
  throw InputError(option, in_quotes(text), "FROM and TO must differ");
}

std::vector<double> parse_values(std::string_view option, std::string_view text,
                                 const Dimension& dimension) {
  if (text.find(':') != std::string_view::npos) return parse_range(option, text, dimension);
  std::vector<double> values;
  for (const std::string_view part : split(text, ',')) {
    values.push_back(parse_quantity(option, part, dimension));
  }
  return values;
}

std::vector<double> parse_range(std::string_view option, std::string_view text,
                                const Dimension& dimension) {
  const auto fail = [&](std::string_view rule, std::string_view remedy = {}) {
    throw InputError(option, in_quotes(text), rule, remedy);
  };
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts.size() == 4 && parts[3] != "log")) {
    fail("must read FROM:TO:COUNT or FROM:TO:COUNT:log", "For instance 1e-6:3e-4:50:log.");
  }
  GivenQuantity first = read_quantity(fmt::format("FROM of {}", option), parts[0], dimension);
  GivenQuantity last = read_quantity(fmt::format("TO of {}", option), parts[1], dimension);
  // In the unit that they are given in 50um:300um:6 is 100 um, not the double below 1e-4.
  if (!first.has_unit_of(last)) {
    first = {first.si(), {.dimension = dimension}};
    last = {last.si(), {.dimension = dimension}};
  }
  const double from = first.value;
  const double to = last.value;
  const std::uint64_t n =
      parse_whole_number(fmt::format("COUNT of {}", option), parts[2], 2, kMostValues);
  const bool log = parts.size() == 4;
  if (!(from < to)) fail("FROM must be below TO", "Swap the two.");
  if (log && from <= 0.0) fail("FROM must be above 0 for equal ratios", "Leave out :log.");

  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto step = static_cast<double>(i);
    const auto steps = static_cast<double>(n - 1);
    values[i] = first.unit.to_si(log ? from * std::pow(to / from, step / steps)
                                     : from + (to - from) * step / steps);
  }
  values.back() = last.si();
  return values;
}

void check_displacement(std::string_view option, double displacement) {
  if (displacement >= 1e-15 && displacement <= 1e6) return;
  throw InputError(option, displacement, "must be above 0 m: from 1e-15 to 1e6");
}

}  // namespace microslip
