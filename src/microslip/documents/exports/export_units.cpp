// SPDX-License-Identifier: MIT
#include "microslip/documents/exports/export_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

constexpr double kInch = 0.0254;       // m, exact by definition
constexpr double kPound = 0.45359237;  // kg, exact by definition
constexpr std::array kExportUnits{
    ExportUnits{"SI", 1.0, 1.0, "N", "m", "N/m"},
    ExportUnits{"mm-N-t", 1.0, 1e-3, "N", "mm", "N/mm"},
    ExportUnits{"in-lbf", kPound* kStandardGravity, kInch, "lbf", "in", "lbf/in"}};

}  // namespace

std::span<const ExportUnits> all_export_units() { return kExportUnits; }

const ExportUnits& export_units(std::string_view name) {
  const auto* const found = std::ranges::find_if(kExportUnits, [&](const ExportUnits& units) {
    return in_capitals(units.name) == in_capitals(name);
  });
  if (found != kExportUnits.end()) return *found;
  std::string names;
  for (const ExportUnits& units : kExportUnits) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", units.name);
  }
  throw InputError("`units`", name, fmt::format("must be one of {}", names));
}

}  // namespace microslip
