// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/comment_entry.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/workflow/campaign/campaign_columns.hpp"

namespace microslip {
namespace {

constexpr double kEmptyCell = std::numeric_limits<double>::quiet_NaN();

struct CampaignCell {
  double measured = kEmptyCell;
  double predicted = kEmptyCell;
  double lower = kEmptyCell;
  double upper = kEmptyCell;
  std::string verdict;
};

/// The quantities of campaign.csv, by their columns.
struct CampaignQuantity {
  std::string_view column;
  std::string_view quantity;  ///< of a ComparedCurve
  Dimension dimension;
};

constexpr std::size_t kQuantities = 6;

const std::array<CampaignQuantity, kQuantities>& campaign_quantities() {
  static const std::array<CampaignQuantity, kQuantities> all{{
      {"amplitude", "displacement", kLength},
      {"force", "force", kForce},
      {"frequency", "frequency", kFrequency},
      {"damping_ratio", "damping_ratio", kDimensionless},
      {"dissipation", "dissipation", kEnergy},
      {"secant_stiffness", "secant_stiffness", kStiffness},
  }};
  return all;
}

struct CampaignRow {
  std::size_t test = 0;  ///< in the plan
  std::string_view part;
  std::string source;
  double mode = kEmptyCell;  ///< from 1; of a level
  std::array<CampaignCell, kQuantities> cells;
  double force_nrmse = kEmptyCell;  ///< of a record of loops
};

CampaignCell cell_at(const ComparedCurve& curve, std::size_t i) {
  CampaignCell cell{.measured = curve.measured[i],
                    .predicted = curve.predicted[i],
                    .verdict = verdict_of(curve, i)};
  if (curve.has_band()) {
    cell.lower = curve.lower[i];
    cell.upper = curve.upper[i];
  }
  return cell;
}

std::size_t column_of(const ComparedCurve& curve) {
  const auto& all = campaign_quantities();
  const auto found = std::ranges::find(all, curve.quantity, &CampaignQuantity::quantity);
  return static_cast<std::size_t>(found - all.begin());
}

CampaignRow level_row(const DoneCampaign& done, std::size_t i) {
  const Levels& levels = done.levels.levels;
  CampaignRow row{.test = done.levels.test[i],
                  .part = "level",
                  .source = done.levels.source[i],
                  .mode = static_cast<double>(done.levels.mode_of(i)),
                  .cells = {}};
  row.cells[0].measured = levels.amplitude[i];
  row.cells[4].measured = levels.dissipation[i];
  row.cells[4].predicted = done.sessions.dissipation[i];
  if (!levels.frequency.empty()) row.cells[2].measured = levels.frequency[i];
  if (!done.found.damping_ratio.empty()) {
    row.cells[3].measured = done.found.measured_damping_ratio[i];
    row.cells[3].predicted = done.found.damping_ratio[i];
  }
  if (!levels.secant_stiffness.empty()) {
    row.cells[5].measured = levels.secant_stiffness[i];
    row.cells[5].predicted = done.found.secant_stiffness[i];
  }
  if (!done.sessions.frequency.empty()) {
    const std::string& session = done.plan.tests[row.test].session;
    const double offset = done.sessions.find(session, done.levels.mode_of(i))->frequency_offset;
    row.cells[2].predicted = done.sessions.frequency[i] * std::exp(offset);
  }
  return row;
}

/// The peak of a sweep; nothing in its cells where there is none.
CampaignRow peak_row(const ComparedTest& test, std::size_t number) {
  CampaignRow row{.test = number, .part = "peak", .source = test.source, .cells = {}};
  for (const ComparedCurve& curve : test.curves) {
    const std::size_t column = column_of(curve);
    if (curve.part == TestPart::kPeak && column < kQuantities) {
      row.cells.at(column) = cell_at(curve, 0);
    }
  }
  return row;
}

/// Error of the joint in the force of a record, relative to its rms.
void add_record_row(const ComparedTest& test, std::size_t number, std::vector<CampaignRow>& rows) {
  const auto found = std::ranges::find(test.curves, "force_nrmse", &ComparedCurve::quantity);
  if (found == test.curves.end()) return;
  CampaignRow row{.test = number, .part = "record", .source = test.source, .cells = {}};
  row.force_nrmse = found->predicted[0];
  rows.push_back(std::move(row));
}

/// The values of a mode or of cycles, a row each: not each amplitude need have all quantities.
void add_curve_rows(const ComparedTest& test, std::size_t number, std::vector<CampaignRow>& rows) {
  for (const ComparedCurve& curve : test.curves) {
    const std::size_t column = column_of(curve);
    if (column >= kQuantities) continue;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      CampaignRow row{.test = number, .part = "curve", .source = test.source, .cells = {}};
      row.cells[0].measured = curve.at[i];
      row.cells.at(column) = cell_at(curve, i);
      rows.push_back(std::move(row));
    }
  }
}

std::vector<CampaignRow> rows_of(const DoneCampaign& done) {
  std::vector<CampaignRow> rows;
  for (std::size_t i = 0; i < done.levels.size(); ++i) rows.push_back(level_row(done, i));
  for (std::size_t n = 0; n < done.verified.tests.size(); ++n) {
    const ComparedTest& test = done.verified.tests[n];
    if (is_of_sweeps(test.kind)) {
      rows.push_back(peak_row(test, done.test_of[n]));
    } else {
      add_curve_rows(test, done.test_of[n], rows);
      add_record_row(test, done.test_of[n], rows);
    }
  }
  return rows;
}

/// Values of a whole test, repeated in tables with one row per level of it.
void add_test_columns(const CampaignFile& plan, const std::vector<std::size_t>& tests,
                      CsvWriter& table) {
  const auto add = [&](const std::string& name, const auto& text) {
    std::vector<std::string> cells;
    for (const std::size_t test : tests) cells.emplace_back(text(plan.tests[test]));
    table.add_text(name, cells);
  };
  add("test", [](const CampaignTest& test) { return test.name; });
  add("use", [](const CampaignTest& test) { return to_string(test.use); });
  add("session", [](const CampaignTest& test) { return test.session; });
  for (const std::string& name : plan.conditions()) {
    add("condition_" + name, [&](const CampaignTest& test) {
      const CampaignCondition* one = test.condition(name);
      return one == nullptr ? std::string() : one->value;
    });
  }
}

template <typename Rows, typename Value>
std::vector<double> column(const Rows& rows, const Value& value) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(value(row));
  return values;
}

void add_quantity(const std::vector<CampaignRow>& rows, std::size_t q, CsvWriter& table) {
  const CampaignQuantity& quantity = campaign_quantities().at(q);
  const auto add = [&](std::string_view ending, double CampaignCell::*member) {
    table.add_numbers_or_empty(
        fmt::format("{}{}", quantity.column, ending), quantity.dimension,
        column(rows, [&](const CampaignRow& row) { return row.cells.at(q).*member; }));
  };
  add("", &CampaignCell::measured);
  add("_predicted", &CampaignCell::predicted);
  add("_lower", &CampaignCell::lower);
  add("_upper", &CampaignCell::upper);
  std::vector<std::string> verdicts;
  for (const CampaignRow& row : rows) verdicts.push_back(row.cells.at(q).verdict);
  table.add_text(fmt::format("{}_verdict", quantity.column), verdicts);
}

/// Each code once, with blanks between.
std::string codes_of(const std::vector<Warning>& warnings) {
  const auto code = [](const Warning& warning) { return warning.code; };
  std::set<std::string> codes;
  std::ranges::transform(warnings, std::inserter(codes, codes.end()), code);
  return fmt::format("{}", fmt::join(codes, " "));
}

/// A row of leave_one_out.csv.
struct LeftOutRow {
  const LeftOut* part;
  std::size_t i;  ///< in it
};

std::string left_out_verdict(const LeftOutRow& row) {
  if (!row.part->failure.empty()) return "not_found";
  const bool beyond = std::isnan(row.part->curve.measured[row.i]);
  return beyond ? "beyond" : verdict_of(row.part->curve, row.i);
}

void add_repeatability(std::string_view key, const std::optional<double>& deviation,
                       CsvWriter& table) {
  if (deviation) table.add_comment(comment_entry(key, "", fmt::format("{}", *deviation)));
}

void add_trend(const TrendKeys& keys, const std::string& condition, const ConditionMean& trend,
               CsvWriter& table) {
  if (!std::isfinite(trend.mean)) return;
  const std::string subject = printable(condition);
  table.add_comment(comment_entry(keys.mean, subject, fmt::format("{}", trend.mean)));
  table.add_comment(comment_entry(keys.sigma, subject, fmt::format("{}", trend.sigma)));
}

}  // namespace

std::string campaign_table(const DoneCampaign& done, const std::string& comment) {
  const std::vector<CampaignRow> rows = rows_of(done);
  CsvWriter table;
  table.add_comment(comment);
  if (!done.plan.title.empty()) {
    table.add_comment(comment_entry(kTitleKey, "", printable(done.plan.title)));
  }
  std::vector<std::size_t> tests;
  std::vector<std::string> parts;
  std::vector<std::string> sources;
  for (const CampaignRow& row : rows) {
    tests.push_back(row.test);
    parts.emplace_back(row.part);
    sources.push_back(row.source);
  }
  add_test_columns(done.plan, tests, table);
  table.add_text("part", parts);
  table.add_text("source", sources);
  if (done.plan.of_model()) {
    table.add_numbers_or_empty("mode", kDimensionless,
                               column(rows, [](const CampaignRow& row) { return row.mode; }));
  }
  for (std::size_t q = 0; q < kQuantities; ++q) add_quantity(rows, q, table);
  table.add_numbers_or_empty("force_nrmse", kDimensionless,
                             column(rows, [](const CampaignRow& row) { return row.force_nrmse; }));
  return table.str();
}

std::string repeatability_text(const SessionEffects& effects) {
  std::string text;
  if (effects.within_sessions) {
    text = fmt::format("{:.2g} % from test to test of a session", 100.0 * *effects.within_sessions);
  }
  if (effects.between_sessions) {
    text += fmt::format("{}{:.2g} % from session to session", text.empty() ? "" : ", ",
                        100.0 * *effects.between_sessions);
  }
  return text;
}

std::string sessions_table(const DoneCampaign& done, const std::string& comment) {
  CsvWriter table;
  table.add_comment(comment);
  add_repeatability(kWithinSessionsKey, done.sessions.within_sessions, table);
  add_repeatability(kBetweenSessionsKey, done.sessions.between_sessions, table);
  add_columns<SessionEffect>(session_columns(done.plan.of_model()), done.sessions.sessions, table);
  return table.str();
}

std::string conditions_table(const DoneCampaign& done, const std::string& comment) {
  std::vector<std::string> names;
  std::vector<ConditionGroup> groups;
  CsvWriter table;
  table.add_comment(comment);
  for (const ConditionEffect& effect : done.conditions) {
    add_trend(kDissipationTrend, effect.name, effect.dissipation_trend, table);
    add_trend(kFrequencyTrend, effect.name, effect.frequency_trend, table);
    if (!effect.common_modes) {
      table.add_comment(comment_entry(kCommonModesKey, printable(effect.name), "no"));
    }
    for (const ConditionGroup& group : effect.groups) {
      names.push_back(effect.name);
      groups.push_back(group);
    }
  }
  table.add_text("condition", names);
  add_columns<ConditionGroup>(condition_columns(), groups, table);
  return table.str();
}

std::string left_out_table(const DoneCampaign& done, const std::string& comment) {
  std::vector<LeftOutRow> rows;
  std::vector<std::size_t> tests;
  std::vector<std::string> names;
  std::vector<std::string> sources;
  std::vector<double> modes;
  std::vector<std::string> verdicts;
  for (const LeftOut& part : done.left_out) {
    for (std::size_t i = 0; i < part.levels.size(); ++i) {
      rows.push_back({&part, i});
      tests.push_back(done.levels.test[part.levels[i]]);
      names.push_back(part.name);
      sources.push_back(done.levels.source[part.levels[i]]);
      modes.push_back(static_cast<double>(done.levels.mode_of(part.levels[i])));
      verdicts.push_back(left_out_verdict(rows.back()));
    }
  }
  CsvWriter table;
  table.add_comment(comment);
  table.add_text("left_out", names);
  table.add_text("part", std::vector(rows.size(), std::string(name_of_part(done.plan.leave_out))));
  add_test_columns(done.plan, tests, table);
  table.add_text("source", sources);
  if (done.plan.of_model()) table.add_numbers("mode", kDimensionless, modes);
  const auto add = [&](const char* name, const Dimension& dimension, const auto& value) {
    table.add_numbers_or_empty(name, dimension, column(rows, value));
  };
  using Row = const LeftOutRow&;
  add("amplitude", kLength, [](Row row) { return row.part->curve.at[row.i]; });
  add("measured", kEnergy, [](Row row) { return row.part->measured[row.i]; });
  add("predicted", kEnergy, [](Row row) { return row.part->curve.predicted[row.i]; });
  add("lower", kEnergy, [](Row row) { return row.part->curve.lower[row.i]; });
  add("upper", kEnergy, [](Row row) { return row.part->curve.upper[row.i]; });
  add("deviation", kDimensionless, [](Row row) { return row.part->deviation(row.i); });
  table.add_text("verdict", verdicts);
  add("mean_deviation", kDimensionless, [](Row row) { return row.part->mean_deviation(); });
  add("chance", kDimensionless,
      [](Row row) { return row.part->curve.compared() > 0 ? row.part->curve.chance : kEmptyCell; });
  std::vector<std::string> contradicts;
  std::vector<std::string> warnings;
  for (const LeftOutRow& row : rows) {
    const LeftOut& part = *row.part;
    contradicts.emplace_back(part.contradicts()        ? "yes"
                             : part.not_judged.empty() ? "no"
                                                       : kNotJudged);
    warnings.push_back(codes_of(part.warnings));
  }
  table.add_text("contradicts", contradicts);
  if (done.plan.of_model()) table.add_text("warnings_of_others", warnings);
  return table.str();
}

}  // namespace microslip
