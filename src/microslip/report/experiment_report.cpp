// SPDX-License-Identifier: MIT
#include "microslip/report/experiment_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/report/sections.hpp"
#include "microslip/workflow/other_methods.hpp"

namespace microslip {
namespace {

/// What sections lack goes into a list of its own before the last section; those that lack
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
  return {
      .title = results.title,
      .subtitle = results.subtitle,
      .sections = with_list_of_missing(
          {summary_section(results, methods), levels_section(results), signals_section(results),
           energies_section(results), density_section(results, methods),
           loops_section(results, methods), stiffness_section(results), responses_section(results),
           predictions_section(results), rig_section(results), provenance_section(results)})};
}

}  // namespace microslip
