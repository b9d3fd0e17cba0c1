// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>
#include <vector>

#include "microslip/report/sections/sections.hpp"

namespace microslip {

ReportSection provenance_section(const ExperimentResults& results) {
  ReportSection section{.title = "Provenance", .blocks = {}};
  section.blocks.emplace_back(ReportFacts{.facts = results.provenance, .one_column = true});
  if (!results.files.empty()) {
    const bool has_commands = std::ranges::any_of(
        results.files, [](const SourceFile& file) { return !file.made_by.empty(); });
    ReportTable table{.title = "Files that this report is made from", .columns = {{"file"}}};
    if (has_commands) table.columns.push_back({.name = "made by", .code = true});
    table.columns.push_back({.name = "SHA-256", .code = true});
    for (const SourceFile& file : results.files) {
      std::vector<ReportCell>& row = table.rows.emplace_back();
      row.emplace_back(file.name);
      if (has_commands) row.emplace_back(file.made_by);
      row.emplace_back(file.sha256);
    }
    section.blocks.emplace_back(std::move(table));
  }
  return section;
}

}  // namespace microslip
