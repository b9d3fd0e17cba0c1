// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/gather.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"
#include "microslip/workflow/reduce/level_table.hpp"

namespace microslip {
namespace {

/// Quantity that not every test has, with the name of its column.
struct OptionalValues {
  std::vector<double> Levels::*values;
  const char* name;
};

constexpr std::array kOptional{
    OptionalValues{&Levels::amplitude_std, "amplitude_std"},
    OptionalValues{&Levels::dissipation_std, "dissipation_std"},
    OptionalValues{&Levels::secant_stiffness, "secant_stiffness"},
    OptionalValues{&Levels::secant_stiffness_std, "secant_stiffness_std"},
    OptionalValues{&Levels::frequency, "frequency"},
    OptionalValues{&Levels::frequency_std, "frequency_std"},
};

/// Adds levels; `all` keeps the values that both have.
void append_levels(const Levels& more, const std::string& test, CampaignLevels& all) {
  const bool first = all.size() == 0;
  for (const OptionalValues& one : kOptional) {
    std::vector<double>& kept = all.levels.*one.values;
    const std::vector<double>& added = more.*one.values;
    if (first || (!kept.empty() && !added.empty())) {
      kept.insert(kept.end(), added.begin(), added.end());
      continue;
    }
    if (kept.empty() && added.empty()) continue;
    kept.clear();
    all.warnings.push_back(
        {"column_not_of_all",
         fmt::format("{} is not used: not all tests to identify from have it, {} among those "
                     "that {}.",
                     one.name, test, added.empty() ? "do not" : "do")});
  }
  std::ranges::copy(more.amplitude, std::back_inserter(all.levels.amplitude));
  std::ranges::copy(more.dissipation, std::back_inserter(all.levels.dissipation));
}

NamedInput levels_of_test(const OpenedCampaign& campaign, std::size_t number,
                          const std::string& out, const std::string& command,
                          const Progress& progress, CampaignLevels& all) {
  const CampaignTest& test = campaign.plan.tests[number];
  const TestFile& file = campaign.tests[number];
  if (file.content == TestContent::kLevels) return {file.path, file.text};
  ReducedCampaignTest reduced = of_campaign_test(
      test, [&] { return reduce_campaign_test(campaign, number, command, progress); });
  const std::string path = levels_path(out, test);
  all.tables.push_back({path, kLevelsKind, std::move(reduced.text)});
  all.converged = all.converged && reduced.converged;
  for (const Warning& warning : reduced.warnings) {
    all.warnings.push_back({warning.code, fmt::format("{}: {}", test.name, warning.text)});
  }
  return {path, all.tables.back().content};
}

void append_test(const CampaignFile& campaign, std::size_t number, const LevelTable& table,
                 CampaignLevels& all) {
  const LevelsFile& used = table.used;
  append_levels(used.levels, campaign.tests[number].name, all);
  for (std::size_t i = 0; i < used.levels.size(); ++i) {
    all.source.push_back(used.source.empty() ? numbered_level(i) : used.source[i]);
    all.test.push_back(number);
    all.flags.push_back(used.flags.empty() ? "" : used.flags[i]);
    all.reversals.push_back(used.reversals.empty() ? 2.0 : used.reversals[i]);
  }
  std::ranges::copy(table.warnings, std::back_inserter(all.warnings));
}

}  // namespace

std::string numbered_level(std::size_t number) { return fmt::format("level {}", number + 1); }

std::string levels_path(const std::string& out, const CampaignTest& test) {
  return (std::filesystem::path(out) / (test.name + "_levels.csv")).string();
}

CampaignLevels campaign_levels(const OpenedCampaign& campaign, const std::string& out,
                               const std::string& command, const Progress& progress) {
  const CampaignFile& plan = campaign.plan;
  CampaignLevels all;
  for (std::size_t t = 0; t < plan.tests.size(); ++t) {
    if (!plan.tests[t].identifies()) continue;
    append_test(plan, t,
                level_table_of(levels_of_test(campaign, t, out, command, progress, all),
                               {.use_inner_reversals = plan.use_inner_reversals,
                                .assemblies = AssemblyColumn::kRefused,
                                .sources = true}),
                all);
  }
  return all;
}

Levels some_levels(const Levels& levels, std::span<const std::size_t> which) {
  const auto some = [&](const std::vector<double>& values) { return gather(values, which); };
  Levels kept{.amplitude = some(levels.amplitude), .dissipation = some(levels.dissipation)};
  for (const OptionalValues& one : kOptional) kept.*one.values = some(levels.*one.values);
  return kept;
}

std::vector<std::string> names_of_levels(const CampaignFile& campaign,
                                         const CampaignLevels& levels) {
  std::map<std::size_t, std::size_t> of_test;  // levels so far
  std::vector<std::string> names;
  for (const std::size_t test : levels.test) {
    names.push_back(fmt::format("{}: level {}", campaign.tests[test].name, ++of_test[test]));
  }
  return names;
}

std::vector<std::string> names_of_levels(const CampaignFile& campaign, const CampaignLevels& levels,
                                         std::span<const std::size_t> which) {
  return gather(names_of_levels(campaign, levels), which);
}

std::string pooled_levels_text(const CampaignLevels& levels, const CampaignFile& campaign,
                               const std::vector<double>& offset, const std::string& comment) {
  Levels corrected = levels.levels;
  for (std::size_t i = 0; i < corrected.frequency.size(); ++i) {
    corrected.frequency[i] *= std::exp(-offset[i]);
  }
  CsvWriter table = levels_table(corrected);
  table.add_comment(comment);
  if (!levels.levels.frequency.empty()) {
    table.add_numbers("frequency", kFrequency, corrected.frequency);
    if (!corrected.frequency_std.empty()) {
      table.add_numbers("frequency_std", kFrequency, corrected.frequency_std);
    }
    table.add_numbers("measured_frequency", kFrequency, levels.levels.frequency);
  }
  std::vector<std::string> tests;
  std::vector<std::string> sessions;
  for (const std::size_t test : levels.test) {
    tests.push_back(campaign.tests[test].name);
    sessions.push_back(campaign.tests[test].session);
  }
  table.add_text("test", tests);
  table.add_text("session", sessions);
  table.add_text("source", levels.source);
  table.add_numbers("reversals", kDimensionless, levels.reversals);
  table.add_text("flags", levels.flags);
  return table.str();
}

}  // namespace microslip
