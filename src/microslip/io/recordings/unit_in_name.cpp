// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/unit_in_name.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {
namespace {

constexpr std::array kMarks{std::pair{UnitMark::kSlash, std::string_view("/")},
                            std::pair{UnitMark::kComma, std::string_view(", ")},
                            std::pair{UnitMark::kWord, std::string_view(" in ")},
                            std::pair{UnitMark::kUnderscore, std::string_view("_")}};

std::string_view text_of(UnitMark mark) {
  return std::ranges::find(kMarks, mark, &std::pair<UnitMark, std::string_view>::first)->second;
}

std::string_view without_parentheses(std::string_view unit) {
  const bool has = unit.size() > 1 && unit.front() == '(' && unit.back() == ')';
  return has ? trimmed(unit.substr(1, unit.size() - 2)) : unit;
}

/// The unit as it is written elsewhere; `N_per_m` is N/m.
std::string written_out(std::string_view unit, UnitMark mark) {
  std::string text(without_parentheses(trimmed(unit)));
  constexpr std::string_view kPer = "_per_";
  for (std::size_t at = text.find(kPer); mark == UnitMark::kUnderscore && at != text.npos;
       at = text.find(kPer)) {
    text.replace(at, kPer.size(), "/");
  }
  return text;
}

/// A number behind `_` is an index, and a single dash nothing.
bool is_unit(std::string_view text, UnitMark mark) {
  if (text.empty()) return false;
  if (mark == UnitMark::kUnderscore && (text == "1" || text == "-")) return false;
  return find_unit(text) || is_other_unit(text);
}

/// In the languages of testing machines.
bool is_time_in_words(std::string_view name) {
  constexpr std::array kTimes{"TIME", "ZEIT", "TEMPS", "TEMPO", "TIEMPO"};
  const std::string capitals = in_capitals(name);
  return capitals == "T" || std::ranges::any_of(kTimes, [&](const char* time) {
           return capitals.find(time) != capitals.npos;
         });
}

/// Whether the name is that of a time or frequency with its unit.
bool names_axis(std::string_view name, UnitMark mark) {
  const std::optional<CsvColumn> column = split_unit_of_name(name, mark);
  const std::optional<Unit> unit = column ? find_unit(*column->unit) : std::nullopt;
  if (!unit) return false;
  const std::string_view quantity = name.substr(0, name.find(text_of(mark)));
  if (unit->dimension == kTime) return is_time_in_words(trimmed(quantity));
  return unit->dimension == kFrequency &&
         (quantity_of_name(quantity) == kFrequency || trimmed(quantity) == "f");
}

}  // namespace

std::optional<CsvColumn> split_unit_of_name(std::string_view name, UnitMark mark) {
  const std::string_view between = text_of(mark);
  const std::optional<Unit> whole = find_unit(name);
  if (whole && whole->dimension == kFrequency) return std::nullopt;  // cycles/min
  for (std::size_t at = name.find(between); at != name.npos; at = name.find(between, at + 1)) {
    std::string unit = written_out(name.substr(at + between.size()), mark);
    const std::string_view before = trimmed(name.substr(0, at));
    if (before.empty() || !is_unit(unit, mark)) continue;
    return CsvColumn{std::string(mark == UnitMark::kUnderscore ? name : before), std::move(unit)};
  }
  return std::nullopt;
}

std::optional<UnitMark> unit_mark_of(std::span<const CsvColumn> columns) {
  for (const auto& [mark, between] : kMarks) {
    const bool found = std::ranges::any_of(columns, [&](const CsvColumn& column) {
      return !column.unit && names_axis(column.name, mark);
    });
    if (found) return mark;
  }
  return std::nullopt;
}

}  // namespace microslip
