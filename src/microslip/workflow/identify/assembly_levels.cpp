// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/assembly_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/reduce/level_table.hpp"
#include "microslip/workflow/text/distinct_files.hpp"

namespace microslip {
namespace {

/// Levels of one assembly as they are gathered.
struct GatheredAssembly {
  std::string name;
  Levels levels = {};
  std::optional<double> stiffness = {};
  TextPlace first = {};  ///< of its levels
};

constexpr std::vector<double> Levels::*kAssemblyColumns[] = {
    &Levels::amplitude,       &Levels::dissipation,      &Levels::amplitude_std,
    &Levels::dissipation_std, &Levels::secant_stiffness, &Levels::secant_stiffness_std,
};

/// An assembly becomes a file of its name.
void check_assembly_name(const std::string& file, const std::string& name) {
  const bool usable = !name.empty() && name.find('/') == std::string::npos &&
                      !name.starts_with('.') && printable(name) == name;
  const bool taken = name == kCommonDensity || name == kNextAssembly;
  if (usable && !taken) return;
  throw InputError(
      fmt::format("{}: name of an assembly", file), in_quotes(name),
      taken ? "must not be a name that densities.csv uses for the mean or the next assembly"
            : "must be usable in the name of a file: without / and not beginning with "
              "a point",
      "Rename it.");
}

GatheredAssembly& gathered_assembly(const std::string& name, const std::string& file,
                                    std::vector<GatheredAssembly>& all) {
  const auto found = std::ranges::find(all, name, &GatheredAssembly::name);
  if (found != all.end()) return *found;
  check_assembly_name(file, name);
  return all.emplace_back(GatheredAssembly{name});
}

void add_assembly_level(const LevelsFile& file, std::size_t row, GatheredAssembly& assembly) {
  if (assembly.levels.amplitude.empty()) {
    assembly.first = {.file = file.file, .line = file.line[row], .column = 0};
  }
  for (const auto column : kAssemblyColumns) {
    const std::vector<double>& values = file.levels.*column;
    if (!values.empty()) (assembly.levels.*column).push_back(values[row]);
  }
  if (file.stiffness.empty()) return;
  const double k = file.stiffness[row];
  if (assembly.stiffness && *assembly.stiffness != k) {
    throw FormatError({.file = file.file, .line = file.line[row], .column = 0},
                      fmt::format("stiffness {:g} N/m, that of other levels of assembly '{}'",
                                  *assembly.stiffness, printable(assembly.name)),
                      fmt::format("{:g}", k), "An assembly has one k.");
  }
  assembly.stiffness = k;
}

void add_assembly_table(const LevelsFile& file, AssembliesBy by,
                        std::vector<GatheredAssembly>& all) {
  if (by == AssembliesBy::kFiles && !file.assembly.empty()) {
    throw InputError(fmt::format("{}: column assembly", printable(file.file)), InputState{"given"},
                     "is not needed where each file is an assembly",
                     "`assemblies column` uses it.");
  }
  if (by == AssembliesBy::kColumn && file.assembly.empty()) {
    throw InputError(fmt::format("{}: column assembly", printable(file.file)),
                     InputState{"missing"}, "must name the assembly of each level",
                     "`assemblies files` takes each file as one.");
  }
  const std::string stem = std::filesystem::path(file.file).stem().string();
  if (by == AssembliesBy::kFiles &&
      std::ranges::find(all, stem, &GatheredAssembly::name) != all.end()) {
    throw InputError("name of an assembly", in_quotes(stem), "is shared by two files",
                     "Name the files differently.");
  }
  for (std::size_t row = 0; row < file.levels.size(); ++row) {
    const std::string& name = by == AssembliesBy::kFiles ? stem : file.assembly[row];
    add_assembly_level(file, row, gathered_assembly(name, printable(file.file), all));
  }
}

void check_losses_of(const GatheredAssembly& assembly) {
  if (std::ranges::any_of(assembly.levels.dissipation, [](double d) { return d > 0.0; })) return;
  throw FormatError(assembly.first,
                    fmt::format("a dissipation above 0 at one level of assembly '{}' at least",
                                printable(assembly.name)),
                    fmt::format("0 at all {} levels from here on", assembly.levels.size()),
                    "Check the column, or leave the assembly out.");
}

}  // namespace

AssemblyLevels read_assembly_levels(const std::vector<std::string>& paths, AssembliesBy by,
                                    bool use_inner_reversals) {
  check_distinct_files(paths);
  AssemblyLevels read;
  std::vector<GatheredAssembly> all;
  for (const std::string& path : paths) {
    const LevelTable table = read_level_table(
        path, {.use_inner_reversals = use_inner_reversals, .assemblies = AssemblyColumn::kUsed});
    add_assembly_table(table.used, by, all);
    read.inputs.push_back({path, sha256(table.input.text)});
    for (const Warning& warning : table.warnings) {
      read.warnings.push_back({warning.code, input_name(path) + ": " + warning.text});
    }
  }
  std::ranges::move(same_content_warnings(read.inputs, "it"), std::back_inserter(read.warnings));
  for (GatheredAssembly& one : all) {
    check_losses_of(one);
    read.count.push_back(one.levels.size());
    try {
      read.assemblies.push_back({one.name, LevelEvidence(std::move(one.levels)), one.stiffness});
    } catch (const InputError& error) {
      throw error.renamed(fmt::format("assembly '{}': {}", printable(one.name), error.name()));
    }
  }
  return read;
}

}  // namespace microslip
