// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/report/sections/sections.hpp"
#include "microslip/workflow/text/flag_meanings.hpp"

namespace microslip {
namespace {

constexpr double kNanometre = 1e-9;   // m
constexpr double kMicrojoule = 1e-6;  // J
constexpr double kNanojoule = 1e-9;   // J

/// Adds a column where there are values.
void add_numbers(ReportTable& table, const char* name, const char* unit,
                 const std::vector<double>& values, double scale, int digits = 4) {
  if (values.empty()) return;
  table.columns.push_back({name, unit, digits});
  for (std::size_t i = 0; i < values.size(); ++i) table.rows.at(i).emplace_back(values[i] / scale);
}

void add_texts(ReportTable& table, const char* name, const std::vector<std::string>& values) {
  if (values.empty()) return;
  table.columns.push_back({name});
  for (std::size_t i = 0; i < values.size(); ++i) table.rows.at(i).emplace_back(values[i]);
}

std::vector<double> numbers_from_one(std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = 1; i <= count; ++i) numbers.push_back(static_cast<double>(i));
  return numbers;
}

/// 0 marks a distortion that is below its noise.
void add_distortion(ReportTable& table, const std::vector<double>& values) {
  if (values.empty()) return;
  table.columns.push_back({"distortion", "%", 2});
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0.0) {
      table.rows.at(i).emplace_back("< noise");
    } else {
      table.rows.at(i).emplace_back(values[i] / kPercent);
    }
  }
}

/// Caption that explains the existing columns.
std::string caption_of(const MeasuredLevels& test) {
  const Levels& levels = test.levels;
  std::string text =
      "A is the amplitude of the displacement, D the energy that a cycle dissipates over it";
  if (!levels.secant_stiffness.empty()) text += ", k_eq the secant stiffness";
  if (!levels.amplitude_std.empty() || !levels.dissipation_std.empty()) {
    text += ", σ standard deviations";
  }
  const bool flagged =
      std::ranges::any_of(test.flags, [](const std::string& flags) { return !flags.empty(); });
  return text + (flagged ? ". Rows with flags are marked." : ".");
}

/// Each code once, in the order of the levels, with the number of levels that have it.
ReportFacts flags_that_occur(const std::vector<std::string>& flags) {
  std::vector<std::pair<std::string, std::size_t>> counts;
  for (const std::string& text : flags) {
    std::istringstream words(text);
    for (std::string code; words >> code;) {
      const auto known =
          std::ranges::find(counts, code, &std::pair<std::string, std::size_t>::first);
      if (known == counts.end()) {
        counts.emplace_back(code, 1);
      } else {
        ++known->second;
      }
    }
  }
  ReportFacts facts{.title = "Flags", .facts = {}, .one_column = true};
  for (const auto& [code, count] : counts) {
    const std::string_view meaning = flag_meaning(code);
    facts.facts.emplace_back(
        code, fmt::format("{}{}{} level{}", meaning, meaning.empty() ? "" : "; ", count,
                          count == 1 ? "" : "s"));
  }
  return facts;
}

}  // namespace

ReportSection levels_section(const ExperimentResults& results) {
  ReportSection section{.title = "Levels", .blocks = {}};
  if (!results.levels) {
    section.blocks.emplace_back(
        ReportMissing{"No levels, energies and stiffnesses: no levels.csv in this folder.",
                      "microslip reduce rig.toml recordings/level_* --out levels.csv"});
    return section;
  }
  const MeasuredLevels& test = *results.levels;
  ReportTable table{.title = "One row per level of vibration", .caption = caption_of(test)};
  table.rows.resize(test.levels.size());
  add_numbers(table, "level", "1", numbers_from_one(test.levels.size()), 1.0, 0);
  add_texts(table, "record", test.source);
  add_numbers(table, "frequency", "Hz", test.frequency, 1.0, 5);
  add_numbers(table, "resonance", "Hz", test.resonance_frequency, 1.0, 5);
  add_numbers(table, "response", "m/s²", test.response_amplitude, 1.0);
  add_numbers(table, "force", "N", test.force_amplitude, 1.0);
  add_distortion(table, test.force_distortion);
  add_numbers(table, "A", "µm", test.levels.amplitude, kMicrometre);
  add_numbers(table, "σ of A", "nm", test.levels.amplitude_std, kNanometre, 2);
  add_numbers(table, "D", "µJ", test.levels.dissipation, kMicrojoule);
  add_numbers(table, "σ of D", "nJ", test.levels.dissipation_std, kNanojoule, 2);
  add_numbers(table, "k_eq", "kN/m", test.levels.secant_stiffness, kKilonewtonPerMetre);
  add_texts(table, "flags", test.flags);
  for (std::size_t i = 0; i < test.flags.size(); ++i) {
    if (!test.flags[i].empty()) table.marked.push_back(i);
  }
  const bool flagged = !table.marked.empty();
  section.blocks.emplace_back(std::move(table));
  if (flagged) section.blocks.emplace_back(flags_that_occur(test.flags));
  return section;
}

}  // namespace microslip
