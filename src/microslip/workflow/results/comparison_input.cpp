// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/comparison_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/comment_entry.hpp"
#include "microslip/io/cells/warning_comment.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/campaign/campaign_columns.hpp"
#include "microslip/workflow/campaign/campaign_conditions.hpp"
#include "microslip/workflow/campaign/campaign_leave_out.hpp"
#include "microslip/workflow/campaign/campaign_tables.hpp"
#include "microslip/workflow/campaign/condition_words.hpp"
#include "microslip/workflow/compare/comparison_table.hpp"
#include "microslip/workflow/compare/comparison_text.hpp"
#include "microslip/workflow/predict/model_draws.hpp"
#include "microslip/workflow/text/table_cells.hpp"

namespace microslip {
namespace {

std::vector<Warning> warnings_in(const CsvTable& table) {
  std::vector<Warning> warnings;
  for (const std::string& comment : table.comments()) {
    if (auto warning = parse_warning_comment(comment)) warnings.push_back(*std::move(warning));
  }
  return warnings;
}

/// A share in the comments, from 0 to 1; nothing where it is not there.
std::optional<double> share_in(const CsvTable& table, std::string_view key,
                               std::string_view subject = {}) {
  const std::optional<double> share = find_number_entry(table.comments(), key, subject);
  if (!share || (*share >= 0.0 && *share <= 1.0)) return share;
  throw FormatError({table.file()}, fmt::format("{} from 0 to 1 in the comments", key),
                    fmt::format("{}", *share));
}

/// Takes from the comments the p-values of curves, and which of them have few values inside.
void take_p_values(const CsvTable& table, std::vector<ComparedTest>& tests) {
  for (ComparedTest& test : tests) {
    for (ComparedCurve& curve : test.curves) {
      if (curve.part != TestPart::kCurve) continue;
      const std::string subject = curve_subject(test, curve);
      if (const auto value = share_in(table, kPValueKey, subject)) curve.chance = *value;
      curve.few_inside = find_entry(table.comments(), kFewInsideKey, subject).has_value();
    }
  }
}

/// How the columns of tests were taken, and their draws.
std::vector<std::pair<std::string, std::string>> notes_in(const CsvTable& table) {
  constexpr std::array kKeys{kDrawsKey, kDrawsFailedKey, kFailureKey, kNoteKey};
  std::vector<std::pair<std::string, std::string>> notes;
  for (const std::string& comment : table.comments()) {
    auto entry = parse_comment_entry(comment);
    if (!entry || std::ranges::find(kKeys, entry->key) == kKeys.end()) continue;
    notes.emplace_back(entry->subject.empty() ? std::move(entry->key) : std::move(entry->subject),
                       std::move(entry->value));
  }
  return notes;
}

struct CampaignColumns {
  std::vector<std::string> verdicts;    ///< names of the columns of verdicts
  std::vector<std::string> conditions;  ///< names of those of conditions
};

CampaignColumns campaign_columns(const CsvTable& table) {
  CampaignColumns columns;
  for (const CsvColumn& column : table.columns()) {
    if (column.name.ends_with("_verdict")) columns.verdicts.push_back(column.name);
    if (column.name.starts_with("condition_")) columns.conditions.push_back(column.name);
  }
  return columns;
}

/// Calls put(entry, cell) for each row of a column of texts.
template <typename Entry, typename Put>
void put_text(const CsvTable& table, const std::string& name, std::vector<Entry>& entries,
              const Put& put) {
  const std::vector<std::string> cells = table.text(name);
  for (std::size_t row = 0; row < entries.size(); ++row) put(entries[row], cells[row]);
}

template <typename Entry>
void put_numbers(const CsvTable& table, const std::string& name, std::vector<Entry>& entries,
                 double Entry::*member) {
  const std::vector<double> values = numbers_or_empty(table, name);
  for (std::size_t row = 0; row < entries.size(); ++row) entries[row].*member = values[row];
}

/// Takes what each part that was left out is: by the names where a table of earlier versions has no
/// such column.
void put_parts(const CsvTable& table, std::vector<LeftOutEntry>& entries) {
  if (table.has("part")) {
    put_text(table, "part", entries,
             [](LeftOutEntry& entry, const std::string& cell) { entry.part = cell; });
    return;
  }
  for (LeftOutEntry& entry : entries) {
    const bool of_level = entry.left_out.starts_with(entry.test + ": level ");
    entry.part = entry.left_out == entry.test ? "test" : of_level ? "level" : "mode";
  }
}

ConditionMean trend_in(const CsvTable& table, const TrendKeys& keys, const std::string& condition) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::string subject = printable(condition);
  return {find_number_entry(table.comments(), keys.mean, subject).value_or(kNone),
          find_number_entry(table.comments(), keys.sigma, subject).value_or(kNone)};
}

}  // namespace

ComparisonFound comparison_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  ComparisonFound found{.tests = compared_tests(table), .warnings = warnings_in(table)};
  found.confidence = share_in(table, kConfidenceKey);
  take_p_values(table, found.tests);
  found.notes = notes_in(table);
  return found;
}

void add_campaign_table(const NamedInput& input, CampaignFound& found) {
  const CsvTable table(input.text, input.path);
  found.title = find_entry(table.comments(), kTitleKey).value_or("");
  const CampaignColumns columns = campaign_columns(table);
  std::vector<CampaignEntry> entries(table.rows());
  for (const auto& [name, member] :
       {std::pair{"test", &CampaignEntry::test}, std::pair{"use", &CampaignEntry::use},
        std::pair{"session", &CampaignEntry::session}, std::pair{"part", &CampaignEntry::part},
        std::pair{"source", &CampaignEntry::source}}) {
    put_text(
        table, name, entries,
        [member = member](CampaignEntry& entry, const std::string& cell) { entry.*member = cell; });
  }
  for (const std::string& name : columns.conditions) {
    const std::string shown = name.substr(name.find('_') + 1);
    put_text(table, name, entries, [&](CampaignEntry& entry, const std::string& cell) {
      if (cell.empty()) return;
      entry.conditions += entry.conditions.empty() ? "" : ", ";
      entry.conditions += condition_text(shown, cell);
    });
  }
  for (const std::string& name : columns.verdicts) {
    put_text(table, name, entries, [](CampaignEntry& entry, const std::string& cell) {
      entry.inside += cell == "inside" ? 1 : 0;
      entry.outside += cell == "outside" ? 1 : 0;
    });
  }
  found.of_model = table.has("mode");
  if (found.of_model) put_numbers(table, "mode", entries, &CampaignEntry::mode);
  put_numbers(table, "amplitude", entries, &CampaignEntry::amplitude);
  put_numbers(table, "frequency", entries, &CampaignEntry::frequency);
  put_numbers(table, "frequency_predicted", entries, &CampaignEntry::frequency_predicted);
  put_numbers(table, "dissipation", entries, &CampaignEntry::dissipation);
  put_numbers(table, "dissipation_predicted", entries, &CampaignEntry::dissipation_predicted);
  found.entries = std::move(entries);
  found.warnings = warnings_in(table);
}

void add_sessions(const NamedInput& input, CampaignFound& found) {
  const CsvTable table(input.text, input.path);
  found.sessions = read_columns(session_columns(table.has("mode")), table);
  SessionEffects effects;
  effects.within_sessions = find_number_entry(table.comments(), kWithinSessionsKey);
  effects.between_sessions = find_number_entry(table.comments(), kBetweenSessionsKey);
  found.repeatability = repeatability_text(effects);
}

void add_conditions(const NamedInput& input, CampaignFound& found) {
  const CsvTable table(input.text, input.path);
  std::vector<ConditionGroup> groups = read_columns(condition_columns(), table);
  const std::vector<std::string> names = table.text("condition");
  for (std::size_t row = 0; row < names.size(); ++row) {
    if (found.conditions.empty() || found.conditions.back().effect.name != names[row]) {
      ConditionEffect effect{.name = names[row]};
      effect.dissipation_trend = trend_in(table, kDissipationTrend, names[row]);
      effect.frequency_trend = trend_in(table, kFrequencyTrend, names[row]);
      found.conditions.push_back({effect, trend_text(effect)});
    }
    found.conditions.back().effect.groups.push_back(std::move(groups[row]));
  }
  for (ConditionFound& condition : found.conditions) {
    condition.effect.overlap = amplitudes_overlap(condition.effect.groups);
    condition.effect.common_modes =
        find_entry(table.comments(), kCommonModesKey, printable(condition.effect.name)) != "no";
  }
}

void add_left_out(const NamedInput& input, CampaignFound& found) {
  const CsvTable table(input.text, input.path);
  std::vector<LeftOutEntry> entries(table.rows());
  put_text(table, "left_out", entries,
           [](LeftOutEntry& entry, const std::string& cell) { entry.left_out = cell; });
  put_text(table, "test", entries,
           [](LeftOutEntry& entry, const std::string& cell) { entry.test = cell; });
  put_parts(table, entries);
  put_text(table, "verdict", entries,
           [](LeftOutEntry& entry, const std::string& cell) { entry.verdict = cell; });
  put_text(table, "contradicts", entries,
           [](LeftOutEntry& entry, const std::string& cell) { entry.contradicts = cell == "yes"; });
  put_text(table, "contradicts", entries,
           [](LeftOutEntry& entry, const std::string& cell) { entry.judged = cell != kNotJudged; });
  put_numbers(table, "amplitude", entries, &LeftOutEntry::amplitude);
  put_numbers(table, "measured", entries, &LeftOutEntry::measured);
  put_numbers(table, "predicted", entries, &LeftOutEntry::predicted);
  put_numbers(table, "lower", entries, &LeftOutEntry::lower);
  put_numbers(table, "upper", entries, &LeftOutEntry::upper);
  put_numbers(table, "mean_deviation", entries, &LeftOutEntry::mean_deviation);
  put_numbers(table, "chance", entries, &LeftOutEntry::chance);
  found.left_out = std::move(entries);
}

}  // namespace microslip
