// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/level_table.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

/// Values of a column from the first to the second limit; 0 too where that has a meaning.
struct Sizes {
  double from;
  double to;
  bool or_zero = true;
};

void check_size(const LevelsFile& file, const std::vector<double>& values, std::string_view name,
                const Sizes& sizes, const Dimension& dimension) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= sizes.from && values[i] <= sizes.to) continue;
    if (values[i] == 0.0 && sizes.or_zero) continue;
    throw FormatError({.file = file.file, .line = file.line[i], .column = 0},
                      fmt::format("{} {}from {:g} to {:g} {}", name, sizes.or_zero ? "0 or " : "",
                                  sizes.from, sizes.to, si_unit(dimension)),
                      fmt::format("{:g}", values[i]),
                      "Check the value and the unit of the column.");
  }
}

/// Far beyond every joint something else was measured or labelled, and products of such numbers
/// leave the range of doubles.
void check_sizes(const LevelsFile& file) {
  constexpr Sizes kEnergies{1e-30, 1e12};
  constexpr Sizes kDeviations{1e-24, 1e6};
  constexpr Sizes kStiffnesses{kSmallestStiffness, kLargestStiffness, false};
  const Levels& levels = file.levels;
  check_size(file, levels.amplitude, "amplitude", {1e-15, 1e6, false}, kLength);
  check_size(file, levels.amplitude_std, "amplitude_std", kDeviations, kLength);
  check_size(file, levels.dissipation, "dissipation", kEnergies, kEnergy);
  check_size(file, levels.dissipation_std, "dissipation_std", kEnergies, kEnergy);
  check_size(file, levels.linear_dissipation, "linear_dissipation", kEnergies, kEnergy);
  check_size(file, levels.secant_stiffness, "secant_stiffness", kStiffnesses, kStiffness);
  check_size(file, file.stiffness, "stiffness", kStiffnesses, kStiffness);
  check_size(file, levels.secant_stiffness_std, "secant_stiffness_std",
             {kSmallestStiffness, kLargestStiffness}, kStiffness);
}

/// D of a level whose joint turns more than twice per cycle is not that of [AR14 (7)].
LevelsFile usable_levels(LevelsFile file, bool use_inner_reversals) {
  if (use_inner_reversals) return file;
  LevelsFile usable = without_inner_reversals(file);
  if (usable.levels.size() > 0) return usable;
  throw FormatError({.file = file.file, .line = file.line.front(), .column = 0},
                    "a level with 2 reversals per cycle",
                    fmt::format("inner reversals in all {}", file.levels.size()),
                    "`inner_reversals use` includes them.");
}

std::optional<Warning> warning_of_reversed(const LevelsFile& all, bool used) {
  const std::vector<std::size_t> lines = all.lines_with_inner_reversals();
  if (lines.empty()) return std::nullopt;
  return Warning{
      used ? "inner_reversals_used" : "levels_left_out",
      fmt::format("{} of {} levels ({} {} of {}) have inner reversals; they were {}.", lines.size(),
                  all.levels.size(), lines.size() == 1 ? "line" : "lines", fmt::join(lines, ", "),
                  printable(all.file), used ? "used nevertheless" : "left out")};
}

/// Flags that the levels used carry.
void warn_of_flags(const LevelsFile& file, std::vector<Warning>& warnings) {
  std::map<std::string, std::size_t> levels_with;
  for (const std::string& flags : file.flags) {
    std::istringstream words(flags);
    std::set<std::string> of_level;
    for (std::string flag; words >> flag;) of_level.insert(flag);
    for (const std::string& flag : of_level) ++levels_with[flag];
  }
  std::string text;
  for (const auto& [flag, count] : levels_with) {
    text += fmt::format("{}{} ({} of {})", text.empty() ? "" : ", ", printable(flag), count,
                        file.levels.size());
  }
  if (text.empty()) return;
  warnings.push_back(
      {"levels_flagged", "levels carry flags: " + text +
                             "; the summary of the command that wrote them explains these."});
}

void check_assembly_column(const LevelsFile& file, AssemblyColumn use) {
  if (use == AssemblyColumn::kIgnored || use == AssemblyColumn::kUsed) return;
  const std::set<std::string> names(file.assembly.begin(), file.assembly.end());
  if (names.size() < 2) return;
  const std::string name = fmt::format("{}: column assembly", printable(file.file));
  const std::string found = fmt::format("{} names", names.size());
  if (use == AssemblyColumn::kRefused) {
    throw InputError(
        name, found, "must be one: levels of one joint are needed",
        "Keep the rows of one assembly, or remove the column to treat all levels as of one "
        "joint.");
  }
  throw InputError(
      name, found, "are ambiguous: different assemblies, or levels of one joint",
      "Choose `assemblies column` for different assemblies, `assemblies none` for one joint.");
}

}  // namespace

LevelTable read_level_table(const std::string& path, const LevelTableOptions& options) {
  return level_table_of({path, read_text(path)}, options);
}

LevelTable level_table_of(NamedInput input, const LevelTableOptions& options) {
  LevelTable table{.input = std::move(input)};
  const LevelsFile all = parse_levels(table.input.text, input_name(table.input.path),
                                      {.linear_dissipation = options.linear_dissipation,
                                       .assemblies = options.assemblies == AssemblyColumn::kUsed,
                                       .sources = options.sources});
  check_assembly_column(all, options.assemblies);
  table.reversed = all.lines_with_inner_reversals();
  table.used = usable_levels(all, options.use_inner_reversals);
  check_sizes(table.used);
  warn_of_flags(table.used, table.warnings);
  table.reversed_warning = warning_of_reversed(all, options.use_inner_reversals);
  if (table.reversed_warning) table.warnings.push_back(*table.reversed_warning);
  return table;
}

}  // namespace microslip
