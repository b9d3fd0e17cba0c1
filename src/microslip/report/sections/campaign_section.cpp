// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/document/scales.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/sections/left_out.hpp"
#include "microslip/report/sections/sections.hpp"
#include "microslip/workflow/campaign/campaign_conditions.hpp"
#include "microslip/workflow/campaign/condition_words.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// The rows of a test.
struct TestRows {
  const CampaignEntry* first;
  std::vector<const CampaignEntry*> levels;  ///< that the joint was identified from
  std::size_t inside = 0;                    ///< of predicted values
  std::size_t outside = 0;
};

std::vector<TestRows> rows_by_test(const std::vector<CampaignEntry>& entries) {
  std::vector<TestRows> tests;
  for (const CampaignEntry& entry : entries) {
    auto found = std::ranges::find_if(
        tests, [&](const TestRows& test) { return test.first->test == entry.test; });
    if (found == tests.end()) found = tests.insert(tests.end(), TestRows{&entry, {}});
    if (entry.part == "level") found->levels.push_back(&entry);
    found->inside += entry.inside;
    found->outside += entry.outside;
  }
  return tests;
}

/// Mean of ln(D/D̂) over levels, 1.
double mean_loss_offset(const std::vector<const CampaignEntry*>& levels) {
  double sum = 0.0;
  for (const CampaignEntry* level : levels) {
    sum += std::log(level->dissipation / level->dissipation_predicted);
  }
  return levels.empty() ? kNotKnown : sum / static_cast<double>(levels.size());
}

double end_of(const std::vector<const CampaignEntry*>& levels, bool largest) {
  double end = kNotKnown;
  for (const CampaignEntry* level : levels) {
    end = largest ? std::fmax(end, level->amplitude) : std::fmin(end, level->amplitude);
  }
  return end;
}

ReportTable campaign_tests_table(const std::vector<TestRows>& tests) {
  ReportTable table{.title = "Tests of the campaign",
                    .caption =
                        "From campaign.csv. Levels: those used for identification. D deviation: "
                        "mean of ln of measured D over that of the joints found. Inside: "
                        "predicted values within their bands.",
                    .columns = {{"test"},
                                {"use"},
                                {"session"},
                                {"conditions"},
                                {"levels", "1", 0},
                                {"from", "µm", 3},
                                {"to", "µm", 3},
                                {"D deviation", "%", 3},
                                {"inside"}}};
  for (const TestRows& test : tests) {
    const std::size_t banded = test.inside + test.outside;
    table.rows.push_back(
        {test.first->test, test.first->use, test.first->session, test.first->conditions,
         static_cast<double>(test.levels.size()), end_of(test.levels, false) / kMicrometre,
         end_of(test.levels, true) / kMicrometre, mean_loss_offset(test.levels) / kPercent,
         banded == 0 ? "" : fmt::format("{} of {}", test.inside, banded)});
  }
  return table;
}

/// Label of the axis of the amplitude of a level.
const char* amplitude_label(const CampaignFound& found) {
  return found.of_model ? "displacement of the response point" : "joint amplitude A";
}

/// Whether the marks of a figure go through more than one decade along x.
bool spans_a_decade(const std::vector<PointLayer>& layers) {
  constexpr double kDecade = 10.0;
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const PointLayer& layer : layers) {
    for (const double x : layer.x) {
      least = std::min(least, x);
      largest = std::max(largest, x);
    }
  }
  return least > 0.0 && largest > kDecade * least;
}

/// Marks over the amplitude, whose scale the reader of a page may change.
void show_over_amplitude(const CampaignFound& found, std::vector<PointLayer> layers,
                         Figure& figure) {
  const bool log = spans_a_decade(layers);
  for (PointLayer& layer : layers) {
    if (!layer.x.empty()) figure.layers.emplace_back(std::move(layer));
  }
  show_x(figure, amplitude_label(found), "m");
  figure.x.log = log;
  figure.x.log_switch = true;
}

/// A layer per session, and per mode of a model: value(level) in % over the amplitude.
template <typename Value>
ReportFigure over_amplitude(const CampaignFound& found, std::string title, std::string caption,
                            const char* label, const Value& value) {
  std::vector<PointLayer> layers;
  for (const CampaignEntry& entry : found.entries) {
    const double shown = entry.part == "level" ? value(entry) : kNotKnown;
    if (!std::isfinite(shown) || !std::isfinite(entry.amplitude)) continue;
    std::string legend = "session " + entry.session;
    if (found.of_model) legend += fmt::format(", mode {}", entry.mode);
    auto layer = std::ranges::find(layers, legend, &PointLayer::legend);
    if (layer == layers.end()) {
      const auto colour = static_cast<int>(layers.size());
      layer = layers.insert(layers.end(), PointLayer{.legend = legend, .colour = colour});
    }
    layer->x.push_back(entry.amplitude);
    layer->y.push_back(shown);
  }
  Figure figure{.title = std::move(title), .caption = std::move(caption)};
  show_over_amplitude(found, std::move(layers), figure);
  show_y(figure, label, ShownUnit{"%", kPercent});
  return {.figure = std::move(figure)};
}

void add_if_drawn(ReportSection& section, ReportFigure figure) {
  if (!figure.figure.layers.empty()) section.blocks.emplace_back(std::move(figure));
}

ReportTable sessions_table(const CampaignFound& found) {
  ReportTable table{.title = "Sessions",
                    .caption =
                        "Frequencies against the first session, and their scatter about their "
                        "mean; D against that of the joints found.",
                    .columns = {{"session"},
                                {"tests", "1", 0},
                                {"levels", "1", 0},
                                {"frequency difference", "%", 3},
                                {"± (σ)", "%", 2},
                                {"corrected by", "%", 3},
                                {"scatter of frequencies", "%", 2},
                                {"D deviation", "%", 3},
                                {"scatter of D", "%", 3}}};
  if (found.of_model) table.columns.insert(table.columns.begin() + 1, {"mode", "1", 0});
  if (!found.repeatability.empty()) {
    table.caption += fmt::format(" The means of D repeat within {}.", found.repeatability);
  }
  for (const SessionEffect& session : found.sessions) {
    table.rows.push_back(
        {session.name, static_cast<double>(session.tests), static_cast<double>(session.levels),
         session.frequency_difference / kPercent, session.frequency_difference_std / kPercent,
         session.frequency_offset / kPercent, session.frequency_scatter / kPercent,
         session.dissipation_offset / kPercent, session.dissipation_scatter / kPercent});
    if (!found.of_model) continue;
    std::vector<ReportCell>& row = table.rows.back();
    row.insert(row.begin() + 1, static_cast<double>(session.mode));
  }
  return table;
}

ReportTable condition_values_table(const std::vector<ConditionFound>& conditions) {
  ReportTable table{
      .title = "Conditions",
      .caption =
          "Levels by the conditions of their tests: deviation of D and frequency from the joints "
          "identified from all, frequency less the offset of the session and, with a model, less "
          "the error of the mode.",
      .columns = {{"condition"},
                  {"value"},
                  {"tests", "1", 0},
                  {"levels", "1", 0},
                  {"from", "µm", 3},
                  {"to", "µm", 3},
                  {"D deviation", "%", 3},
                  {"± (σ)", "%", 2},
                  {"frequency deviation", "%", 3},
                  {"± (σ)", "%", 2}}};
  for (const ConditionFound& condition : conditions) {
    for (const ConditionGroup& group : condition.effect.groups) {
      table.rows.push_back({condition_title(condition.effect.name), group.value,
                            static_cast<double>(group.tests), static_cast<double>(group.levels),
                            group.least / kMicrometre, group.largest / kMicrometre,
                            group.dissipation.mean / kPercent, group.dissipation.sigma / kPercent,
                            group.frequency.mean / kPercent, group.frequency.sigma / kPercent});
    }
  }
  return table;
}

ReportTable condition_verdicts_table(const std::vector<ConditionFound>& conditions) {
  ReportTable table{.title = "Effect of conditions",
                    .caption =
                        "Trends by least squares over the means of the values. Marked: values "
                        "that differ by more than three standard deviations.",
                    .columns = {{"condition"}, {"trend"}, {"equal"}, {"verdict"}}};
  for (const ConditionFound& condition : conditions) {
    const ConditionVerdict verdict = condition_verdict(condition.effect);
    if (verdict.differ) table.marked.push_back(table.rows.size());
    const bool pooled = condition.effect.pooled();
    table.rows.push_back({condition_title(condition.effect.name), condition.trend,
                          std::string(!pooled          ? ""
                                      : verdict.differ ? "no"
                                                       : "yes"),
                          pooled ? verdict.text : "one value: nothing to compare"});
  }
  return table;
}

ReportTable left_out_table_of(const CampaignFound& found) {
  ReportTable table{.title = "Left out",
                    .caption =
                        "Each left out in turn and predicted from the others; levels beyond "
                        "their range are not compared. Marked: contradicts the others, as one in "
                        "twenty does by chance.",
                    .columns = {{"left out"},
                                {"levels", "1", 0},
                                {"compared", "1", 0},
                                {"D deviation", "%", 3},
                                {"inside", "1", 0},
                                {"p-value", "%", 2},
                                {"contradicts"}}};
  for (const PartLeftOut& part : parts_left_out(found)) {
    if (part.contradicts) table.marked.push_back(table.rows.size());
    table.rows.push_back({part.name, static_cast<double>(part.levels),
                          static_cast<double>(part.compared), part.mean_deviation / kPercent,
                          static_cast<double>(part.inside), part.chance / kPercent,
                          std::string(part.contradicts ? "yes"
                                      : part.judged    ? "no"
                                                       : "not judged")});
  }
  return table;
}

/// The marks of what was left out that one owner, the test of a level, has inside or outside of the
/// band: one entry of the legend, and on paper outlines and full ones.
PointLayer& marks_of(const LeftOutEntry& row, std::vector<PointLayer>& layers) {
  const std::string& owner = row.part == "level" ? row.test : row.left_out;
  const bool outside = row.verdict == "outside";
  const std::string name = owner + (outside ? ", outside" : ", inside");
  const auto known = std::ranges::find(layers, name, &PointLayer::name);
  if (known != layers.end()) return *known;
  const auto same = std::ranges::find(layers, owner, &PointLayer::legend);
  std::set<std::string> owners;
  for (const PointLayer& layer : layers) owners.insert(layer.legend);
  const int colour = same != layers.end() ? same->colour : static_cast<int>(owners.size());
  layers.push_back({.legend = owner, .colour = colour, .open = !outside, .name = name});
  return layers.back();
}

/// D of what was left out over what the others predict, with the band of that.
ReportFigure left_out_figure(const CampaignFound& found) {
  std::vector<const LeftOutEntry*> rows;
  for (const LeftOutEntry& entry : found.left_out) {
    if (std::isfinite(entry.measured) && entry.predicted > 0.0) rows.push_back(&entry);
  }
  std::ranges::stable_sort(rows, {}, &LeftOutEntry::amplitude);
  PointLayer band{.legend = "centre and edges of the band", .colour = kGrey};
  std::vector<PointLayer> measured;
  for (const LeftOutEntry* row : rows) {
    PointLayer& layer = marks_of(*row, measured);
    layer.x.push_back(row->amplitude);
    layer.y.push_back(row->measured / row->predicted - 1.0);
    if (!std::isfinite(row->lower) || !std::isfinite(row->upper)) continue;
    band.x.push_back(row->amplitude);
    band.y.push_back(0.5 * (row->lower + row->upper) / row->predicted - 1.0);
    band.y_error.push_back(0.5 * (row->upper - row->lower) / row->predicted);
  }
  Figure figure{.title = "Left-out dissipation",
                .caption =
                    "Measured over the prediction from the others, less 1, with the band of a "
                    "measurement."};
  measured.insert(measured.begin(), std::move(band));
  show_over_amplitude(found, std::move(measured), figure);
  show_y(figure, "D over prediction, less 1", ShownUnit{"%", kPercent});
  return {.figure = std::move(figure)};
}

std::string lead_of_campaign(const std::vector<TestRows>& tests, const CampaignFound& found) {
  std::size_t levels = 0;
  std::size_t identify = 0;
  for (const TestRows& test : tests) {
    levels += test.levels.size();
    identify += test.levels.empty() ? 0 : 1;
  }
  std::set<std::string> sessions;
  for (const SessionEffect& session : found.sessions) sessions.insert(session.name);
  return fmt::format(
      "Several tests of one structure: {} of {} identify {}, in {}; the "
      "others, and those used for both, are predicted.",
      counted(levels, found.of_model ? "modal level" : "level"), counted(identify, "test"),
      found.of_model ? "its joints" : "the joint", counted(sessions.size(), "session"));
}

}  // namespace

ReportSection campaign_section(const ExperimentResults& results) {
  ReportSection section{.title = "Campaign", .blocks = {}};
  if (!results.campaign) return section;
  const CampaignFound& found = *results.campaign;
  const std::vector<TestRows> tests = rows_by_test(found.entries);
  section.blocks.emplace_back(ReportText{lead_of_campaign(tests, found)});
  if (!found.warnings.empty()) section.blocks.emplace_back(ReportWarnings{found.warnings});
  const char* const against =
      found.of_model ? "Dissipation against the joints" : "Dissipation against the joint";
  add_if_drawn(
      section,
      over_amplitude(found, against,
                     found.of_model ? "Of each level, over that of all joints as identified from "
                                      "all tests, less 1."
                                    : "Of each level, over that of the joint as identified from "
                                      "all tests, less 1.",
                     "D over identified, less 1", [](const CampaignEntry& level) {
                       return level.dissipation / level.dissipation_predicted - 1.0;
                     }));
  add_if_drawn(section,
               over_amplitude(found, "Frequency against the model",
                              found.of_model
                                  ? "Of each level, over that of the model with its joints, less 1."
                                  : "Of each level, over that of the model with the joint, less 1.",
                              "f over model, less 1", [](const CampaignEntry& level) {
                                return level.frequency / level.frequency_predicted - 1.0;
                              }));
  section.blocks.emplace_back(campaign_tests_table(tests));
  if (!found.sessions.empty()) section.blocks.emplace_back(sessions_table(found));
  if (!found.conditions.empty()) {
    section.blocks.emplace_back(condition_values_table(found.conditions));
    section.blocks.emplace_back(condition_verdicts_table(found.conditions));
  }
  if (!found.left_out.empty()) {
    add_if_drawn(section, left_out_figure(found));
    section.blocks.emplace_back(left_out_table_of(found));
  }
  return section;
}

}  // namespace microslip
