// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/levels_file.hpp"

#include <type_traits>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/tables/column_rules.hpp"
#include "microslip/io/tables/csv.hpp"

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

/// That of the resonance where the file has it, else that of the drive, with the deviation of the
/// same.
void read_frequency(const CsvTable& table, Levels& levels) {
  for (const std::string name : {"resonance_frequency", "frequency"}) {
    if (!table.has(name)) continue;
    levels.frequency = table.numbers(name, kFrequency);
    require_positive(table, name, levels.frequency,
                     "Where it is not known at every level, remove the column.");
    levels.frequency_std = table.numbers_if_present(name + "_std", kFrequency);
    require_non_negative(table, name + "_std", levels.frequency_std);
    return;
  }
}

void read_linear_loss(const CsvTable& table, LinearLossColumn use, Levels& levels) {
  if (use == LinearLossColumn::kIgnored) return;
  levels.linear_dissipation = use == LinearLossColumn::kNeeded
                                  ? table.numbers("linear_dissipation", kEnergy)
                                  : table.numbers_if_present("linear_dissipation", kEnergy);
  require_non_negative(table, "linear_dissipation", levels.linear_dissipation);
}

/// Names in the column `assembly`, and k beside them.
void read_assemblies(const CsvTable& table, bool used, LevelsFile& file) {
  if (table.has("assembly")) file.assembly = table.text("assembly");
  if (!used) return;
  for (std::size_t row = 0; row < file.assembly.size(); ++row) {
    if (file.assembly[row].empty()) {
      table.reject(row, "assembly", "the name of an assembly", "Name it, or remove the level.");
    }
  }
  file.stiffness = table.numbers_if_present("stiffness", kStiffness);
  require_positive(table, "stiffness", file.stiffness);
}

}  // namespace

LevelsFile parse_levels(std::string text, std::string_view file, const LevelsReadOptions& options) {
  const CsvTable table(std::move(text), file);
  Levels levels;
  levels.amplitude = table.numbers("amplitude", kLength);
  if (table.has("damping_ratio") && !table.has("dissipation")) {
    throw FormatError({table.file()}, "a column 'dissipation'", "damping ratios alone",
                      "A damping ratio gives no dissipation without the modal mass: give "
                      "`modal_mass` to ringdown.");
  }
  levels.dissipation = table.numbers("dissipation", kEnergy);
  for (const OptionalColumn& column : kOptionalColumns) {
    levels.*column.values = table.numbers_if_present(column.name, column.dimension);
    if (column.values != &Levels::secant_stiffness) {
      require_non_negative(table, column.name, levels.*column.values);
    }
  }
  require_positive(table, "amplitude", levels.amplitude, kRemedyForNoMotion);
  require_non_negative(table, "dissipation", levels.dissipation,
                       "A contact cannot give energy: remove the row, or check the phase.");
  require_positive(table, "secant_stiffness", levels.secant_stiffness);
  read_frequency(table, levels);
  std::vector<double> reversals = table.numbers_if_present("reversals", kDimensionless);
  require_non_negative(table, "reversals", reversals);
  read_linear_loss(table, options.linear_dissipation, levels);
  std::vector<std::string> flags;
  if (table.has("flags")) flags = table.text("flags");
  LevelsFile read{std::move(levels), table.file(), table.row_lines(), std::move(reversals),
                  std::move(flags)};
  read_assemblies(table, options.assemblies, read);
  if (options.sources && table.has("source")) read.source = table.text("source");
  return read;
}

std::vector<std::size_t> LevelsFile::lines_with_inner_reversals() const {
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (has_inner_reversals(i)) lines.push_back(line[i]);
  }
  return lines;
}

LevelsFile without_inner_reversals(const LevelsFile& file) {
  const auto kept = [&](const auto& values) {
    std::remove_cvref_t<decltype(values)> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!file.has_inner_reversals(i)) result.push_back(values[i]);
    }
    return result;
  };
  LevelsFile result;
  result.file = file.file;
  result.line = kept(file.line);
  result.reversals = kept(file.reversals);
  result.flags = kept(file.flags);
  result.assembly = kept(file.assembly);
  result.stiffness = kept(file.stiffness);
  result.source = kept(file.source);
  result.levels.linear_dissipation = kept(file.levels.linear_dissipation);
  result.levels.frequency = kept(file.levels.frequency);
  result.levels.frequency_std = kept(file.levels.frequency_std);
  result.levels.amplitude = kept(file.levels.amplitude);
  result.levels.dissipation = kept(file.levels.dissipation);
  for (const OptionalColumn& column : kOptionalColumns) {
    result.levels.*column.values = kept(file.levels.*column.values);
  }
  return result;
}

LevelsFile read_levels(const std::string& path) {
  return parse_levels(read_text(path), input_name(path));
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
