// SPDX-License-Identifier: MIT
#include "microslip/io/levels_file.hpp"

#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/column_rules.hpp"
#include "microslip/io/csv.hpp"
#include "microslip/io/input_file.hpp"

namespace microslip {
namespace {

struct OptionalColumn {
  std::string_view name;
  Dimension dimension;
  std::vector<double> Levels::*values;
};

constexpr OptionalColumn kOptionalColumns[] = {
    {"amplitude_std", kLength, &Levels::amplitude_std},
    {"dissipation_std", kEnergy, &Levels::dissipation_std},
    {"secant_stiffness", kStiffness, &Levels::secant_stiffness},
    {"secant_stiffness_std", kStiffness, &Levels::secant_stiffness_std},
};

}  // namespace

LevelsFile parse_levels(std::string text, std::string_view file) {
  const CsvTable table(std::move(text), file);
  Levels levels;
  levels.amplitude = table.numbers("amplitude", kLength);
  levels.dissipation = table.numbers("dissipation", kEnergy);
  for (const OptionalColumn& column : kOptionalColumns) {
    levels.*column.values = table.numbers_if_present(column.name, column.dimension);
    if (column.values != &Levels::secant_stiffness) {
      require_non_negative(table, column.name, levels.*column.values);
    }
  }
  require_positive(table, "amplitude", levels.amplitude,
                   "A level without motion tells nothing: remove the row.");
  require_non_negative(table, "dissipation", levels.dissipation,
                       "A contact cannot give energy: remove the row, or check the phase.");
  require_positive(table, "secant_stiffness", levels.secant_stiffness);
  return {std::move(levels), table.file(), table.row_lines()};
}

LevelsFile read_levels(const std::string& path) {
  return parse_levels(read_file(path), input_name(path));
}

CsvWriter levels_table(const Levels& levels) {
  CsvWriter writer;
  writer.add_numbers("amplitude", kLength, levels.amplitude);
  writer.add_numbers("dissipation", kEnergy, levels.dissipation);
  for (const OptionalColumn& column : kOptionalColumns) {
    const std::vector<double>& values = levels.*column.values;
    if (!values.empty()) writer.add_numbers(column.name, column.dimension, values);
  }
  return writer;
}

}  // namespace microslip
