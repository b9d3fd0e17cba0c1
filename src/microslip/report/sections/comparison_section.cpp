// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/figures/comparison_figure.hpp"
#include "microslip/report/sections/prediction_reach.hpp"
#include "microslip/report/sections/sections.hpp"
#include "microslip/report/sections/verdict_block.hpp"
#include "microslip/workflow/compare/comparison_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

/// More rows are not listed; the file has them all.
constexpr std::size_t kMostRows = 200;

std::string band_text(const ComparedCurve& curve, std::size_t i) {
  if (!curve.has_band()) return "";
  return fmt::format("{} to {}", value_text(curve.lower[i], curve.dimension),
                     value_text(curve.upper[i], curve.dimension));
}

/// "at 79.6 Hz"; empty of a whole record.
std::string place_text(const ComparedCurve& curve, std::size_t i) {
  return curve.axis.empty() ? "" : value_text(curve.at[i], curve.axis_dimension);
}

/// Values by themselves: peaks, records, amplitudes of a mode, cycles of a record. The steps of a
/// sweep are in its figures.
bool is_listed(const ComparedTest& test, const ComparedCurve& curve) {
  return curve.part != TestPart::kCurve || !is_of_sweeps(test.kind);
}

ReportTable values_table(const std::vector<ComparedTest>& tests) {
  ReportTable table{.title = "Measured and predicted values",
                    .caption =
                        "Peaks of sweeps, amplitudes of modes, cycles and whole "
                        "records. Marked: outside of the band, or not found.",
                    .columns = {{"test"},
                                {"quantity"},
                                {"at"},
                                {"measured"},
                                {"predicted"},
                                {"difference"},
                                {"band"},
                                {"verdict"}}};
  std::size_t left_out = 0;
  for (const ComparedTest& test : tests) {
    for (const ComparedCurve& curve : test.curves) {
      if (!is_listed(test, curve)) continue;
      for (std::size_t i = 0; i < curve.size(); ++i) {
        if (table.rows.size() == kMostRows) {
          ++left_out;
          continue;
        }
        const std::string verdict = verdict_of(curve, i);
        if (verdict == "outside" || verdict == "not_found") {
          table.marked.push_back(table.rows.size());
        }
        table.rows.push_back({test.source, shown_name(curve), place_text(curve, i),
                              value_text(curve.measured[i], curve.dimension),
                              value_text(curve.predicted[i], curve.dimension),
                              difference_text(curve, i), band_text(curve, i),
                              verdict == "not_found" ? "not found" : verdict});
      }
    }
  }
  if (left_out > 0) {
    table.caption += fmt::format(" {} more are in comparison.csv.", left_out);
  }
  return table;
}

ReportTable curves_table(const ComparisonFound& found) {
  ReportTable table{
      .title = "Tests as a whole",
      .caption =
          "rms of predicted less measured, relative except for phases. p-value: share of draws "
          "with as few values inside or fewer. Marked: so small that the draws do not explain the "
          "test (few_inside).",
      .columns = {{"test"},
                  {"kind"},
                  {"quantity"},
                  {"values", "1", 0},
                  {"rms difference"},
                  {"inside", "1", 0},
                  {"expected", "1", 3},
                  {"p-value", "%", 3}}};
  for (const ComparedTest& test : found.tests) {
    for (const ComparedCurve& curve : test.curves) {
      if (curve.part != TestPart::kCurve) continue;
      if (curve.few_inside) table.marked.push_back(table.rows.size());
      const auto count = static_cast<double>(curve.compared());
      const double none = std::nan("");
      table.rows.push_back({test.source, std::string(to_string(test.kind)), shown_name(curve),
                            count, deviation_text(curve),
                            curve.has_band() ? static_cast<double>(curve.inside()) : none,
                            curve.has_band() && found.confidence ? *found.confidence * count : none,
                            100.0 * curve.chance});
    }
  }
  return table;
}

std::string lead_of_comparison(const ComparisonFound& found) {
  if (!found.of_this_model) {
    return "comparison.csv is of another joint or model than those beside it: run verify again.";
  }
  return fmt::format(
      "Predictions of the model for {}, against measurements, from comparison.csv: {}.",
      counted(found.tests.size(), "test"), comparison_verdict(found));
}

}  // namespace

ReportSection comparison_section(const ExperimentResults& results) {
  ReportSection section{.title = "Tests against the model", .blocks = {}};
  if (!results.comparison) return section;
  const ComparisonFound& found = *results.comparison;
  section.blocks.emplace_back(ReportText{lead_of_comparison(found)});
  if (!found.warnings.empty()) section.blocks.emplace_back(ReportWarnings{found.warnings});
  for (ReportFigure& figure : comparison_figures(found.tests)) {
    section.blocks.emplace_back(std::move(figure));
  }
  ReportTable curves = curves_table(found);
  if (!curves.rows.empty()) section.blocks.emplace_back(std::move(curves));
  ReportTable values = values_table(found.tests);
  if (!values.rows.empty()) section.blocks.emplace_back(std::move(values));
  if (!found.notes.empty()) {
    section.blocks.emplace_back(
        ReportFacts{.title = "Comparison settings", .facts = found.notes, .one_column = true});
  }
  return section;
}

ReportSection comparison_summary_section(const ExperimentResults& results) {
  const ComparisonFound& found = *results.comparison;
  ReportSection section{.title = "Summary", .blocks = {}};
  std::vector<Warning> warnings = results.warnings;
  std::ranges::copy(found.warnings, std::back_inserter(warnings));
  ReportVerdict verdict{.text = comparison_verdict(found), .codes = codes_of(warnings)};
  const bool is_judged = found.of_this_model && found.confidence;
  verdict.doubtful = !is_judged || std::ranges::any_of(found.warnings, [&](const Warning& warning) {
    return speaks_against(found, warning);
  });
  section.blocks.emplace_back(std::move(verdict));
  std::vector<ReportFigure> figures = comparison_figures(found.tests);
  if (!figures.empty()) section.blocks.emplace_back(std::move(figures.front()));
  section.blocks.emplace_back(reach_of_comparison(found));
  section.blocks.emplace_back(ReportWarnings{.warnings = std::move(warnings), .beside = true});
  return section;
}

}  // namespace microslip
