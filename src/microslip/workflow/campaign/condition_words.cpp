// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/condition_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

struct NameAndUnit {
  std::string name;
  std::string unit;  ///< empty without one
};

NameAndUnit parts_of(std::string_view name) {
  const std::size_t bar = name.rfind('_');
  const bool has_both = bar != std::string_view::npos && bar > 0 && bar + 1 < name.size();
  if (!has_both || !find_unit(name.substr(bar + 1))) return {printable(name), {}};
  NameAndUnit parts{printable(name.substr(0, bar)), printable(name.substr(bar + 1))};
  std::ranges::replace(parts.name, '_', ' ');
  return parts;
}

}  // namespace

std::string condition_text(std::string_view name, std::string_view values) {
  const NameAndUnit parts = parts_of(name);
  return fmt::format("{} {}{}{}", parts.name, printable(values), parts.unit.empty() ? "" : " ",
                     parts.unit);
}

std::string condition_title(std::string_view name) {
  const NameAndUnit parts = parts_of(name);
  return parts.unit.empty() ? parts.name : fmt::format("{} [{}]", parts.name, parts.unit);
}

std::string condition_step(std::string_view name) {
  const NameAndUnit parts = parts_of(name);
  return fmt::format("{} of {}", parts.unit.empty() ? "unit" : parts.unit, parts.name);
}

}  // namespace microslip
