// SPDX-License-Identifier: MIT
#include "microslip/report/sections/experiment_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/report/sections/calibration_sections.hpp"
#include "microslip/report/sections/record_sections.hpp"
#include "microslip/report/sections/sections.hpp"
#include "microslip/workflow/results/other_methods.hpp"

namespace microslip {
namespace {

/// Moves the missing contents of sections to a list before the last section; those that lack
/// everything are left out. The summary keeps what it lacks.
std::vector<ReportSection> with_list_of_missing(std::vector<ReportSection> all) {
  const auto is_missing = [](const ReportBlock& block) {
    return std::holds_alternative<ReportMissing>(block);
  };
  ReportSection missing{.title = "Not in this report", .blocks = {}};
  for (auto section = all.begin() + 1; section != all.end(); ++section) {
    std::vector<ReportBlock>& blocks = section->blocks;
    std::ranges::copy_if(blocks, std::back_inserter(missing.blocks), is_missing);
    std::erase_if(blocks, is_missing);
  }
  std::erase_if(all, [](const ReportSection& section) { return section.blocks.empty(); });
  if (!missing.blocks.empty()) all.insert(all.end() - 1, std::move(missing));
  return all;
}

/// Each warning where it is shown first: several files have the same, and sections show theirs.
void show_warnings_once(std::vector<ReportSection>& all) {
  std::set<std::pair<std::string, std::string>> shown;
  for (ReportSection& section : all) {
    for (ReportBlock& block : section.blocks) {
      if (auto* one = std::get_if<ReportWarnings>(&block)) {
        std::erase_if(one->warnings, [&](const Warning& warning) {
          return !shown.emplace(warning.code, warning.text).second;
        });
      }
    }
  }
  for (auto section = all.begin() + 1; section != all.end(); ++section) {
    std::erase_if(section->blocks, [](const ReportBlock& block) {
      const auto* one = std::get_if<ReportWarnings>(&block);
      return one != nullptr && one->warnings.empty();
    });
  }
}

/// Whether the folder holds a test by levels, or a part of one.
bool has_test(const ExperimentResults& results) {
  return results.levels || !results.records.empty() || !results.comparisons.empty() ||
         !results.predictions.empty() || !results.force_control.empty();
}

std::vector<ReportSection> sections_of(const ExperimentResults& results,
                                       const std::optional<MethodComparison>& methods) {
  const bool of_records = results.joint && results.joint->by_records;
  std::vector<ReportSection> all;
  const auto add = [&all](ReportSection section) { all.push_back(std::move(section)); };
  if (has_calibration(results)) {
    add(calibration_summary_section(results));
    add(modes_section(results));
    add(joints_at_levels_section(results));
    add(identifiability_section(results));
    if (!has_test(results)) {
      add(comparison_section(results));
      add(campaign_section(results));
      add(curves_section(results));
      add(provenance_section(results));
      return all;
    }
  }
  const bool by_comparison =
      results.comparison && !results.joint && !results.campaign && !has_test(results);
  if (by_comparison) {
    add(comparison_summary_section(results));
  } else if (of_records) {
    add(record_summary_section(results));
    add(record_force_section(results));
    add(record_loops_section(results));
    if (!results.levels) add(derived_section(results));
    add(records_section(results));
  } else {
    add(summary_section(results, methods));
  }
  if (has_test(results) || !(of_records || by_comparison)) {
    add(levels_section(results));
    add(signals_section(results));
    add(energies_section(results));
    add(density_section(results, methods));
    add(loops_section(results, methods));
    add(stiffness_section(results));
    add(responses_section(results));
    add(predictions_section(results));
    add(rig_section(results));
  }
  add(comparison_section(results));
  add(campaign_section(results));
  add(curves_section(results));
  add(provenance_section(results));
  return all;
}

}  // namespace

ReportDocument experiment_report(ExperimentResults results) {
  check_results(results);
  std::optional<MethodComparison> methods;
  try {
    methods = compare_methods(results);
  } catch (const InputError& error) {
    results.warnings.push_back(
        {"no_other_methods",
         fmt::format("The levels were not evaluated again, for comparison: {}", error.what())});
  }
  std::vector<ReportSection> sections = sections_of(results, methods);
  show_warnings_once(sections);
  return {.title = results.title,
          .subtitle = results.subtitle,
          .sections = with_list_of_missing(std::move(sections))};
}

}  // namespace microslip
