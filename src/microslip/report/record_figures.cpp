// SPDX-License-Identifier: MIT
#include "microslip/report/record_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <ranges>
#include <string_view>
#include <utility>

#include "microslip/report/scales.hpp"
#include "microslip/report/sections.hpp"
#include "microslip/report/shown_unit.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostChannels = 8;  // of a figure: as many as there are colours

std::string with(const std::string& name, std::string_view which) {
  return which.empty() ? name : fmt::format("{}, {}", name, which);
}

/// Displacements of a joint are micrometres.
std::pair<std::string, double> unit_of_signal(const std::string& unit) {
  if (unit == "m") return {"µm", kMicrometre};
  return {shown_unit(unit, 1.0).text, 1.0};
}

std::vector<std::string> units_of(const std::vector<LevelRecord>& records) {
  std::vector<std::string> units;
  for (const LevelRecord& record : records) {
    for (const SignalPair& signal : record.signals) {
      if (std::ranges::find(units, signal.unit) == units.end()) units.push_back(signal.unit);
    }
  }
  return units;
}

/// "level_07.csv (3.2 m/s²)"
std::string label_of(const std::string& source, const ExperimentResults& results) {
  const std::string_view name = file_name(source);
  if (results.levels && !results.levels->response_amplitude.empty()) {
    const std::vector<std::string>& sources = results.levels->source;
    const auto found = std::ranges::find(sources, name, file_name);
    if (found != sources.end()) {
      const auto level = static_cast<std::size_t>(found - sources.begin());
      return fmt::format("{} ({:.3g} m/s²)", name, results.levels->response_amplitude[level]);
    }
  }
  return std::string(name);
}

/// The two curves of a signal.
void add_signal(const SignalPair& signal, const RecordNames& names, int colour, double scale,
                std::vector<ReportTrace>& traces) {
  const bool compares = !signal.other.empty();
  traces.push_back(
      {.name = with(signal.name, names.recorded),
       .x = in_unit(signal.time, kMillisecond),
       .y = in_unit(signal.recorded, scale),
       .stroke = {.colour = colour, .width = compares && names.other_shown ? 3.2 : 1.6}});
  if (!compares) return;
  traces.push_back(
      {.name = with(signal.name, names.other),
       .group = names.other,
       .x = in_unit(signal.other_time, kMillisecond),
       .y = in_unit(signal.other, scale),
       .stroke = {.colour = names.other_colour, .style = LineStyle::kDashed, .width = 1.2},
       .shown = names.other_shown || signal.unit == "N"});
}

/// "8 of the 200 channels are shown.", where a record has more than a figure shows.
std::string left_out_text(std::size_t channels) {
  if (channels <= kMostChannels) return {};
  return fmt::format("The first {} of the {} channels of the record are shown.", kMostChannels,
                     channels);
}

/// The signals of one unit, a choice a record.
ReportFigure history_figure(const ExperimentResults& results,
                            const std::vector<LevelRecord>& records, const std::string& unit,
                            const RecordNames& names) {
  const auto [shown, scale] = unit_of_signal(unit);
  std::string title = quantity_of_unit(unit);
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  ReportFigure figure{.title = title + " over time",
                      .chart = ChartKind::kTimeHistory,
                      .x = {.label = "time", .unit = "ms"},
                      .y = {.label = quantity_of_unit(unit), .unit = shown},
                      .choose = "Record",
                      .wide = true};
  std::size_t most = 0;
  for (const LevelRecord& record : records) {
    ReportChoice choice{label_of(record.source, results), {}};
    int colour = kBlue;
    std::size_t channels = 0;
    for (const SignalPair& signal : record.signals) {
      if (signal.unit != unit || ++channels > kMostChannels) continue;
      add_signal(signal, names, colour, scale, choice.traces);
      ++colour;
      if (!signal.other.empty() && colour % kColours == names.other_colour) ++colour;
    }
    // In front of all recorded ones.
    std::ranges::stable_partition(choice.traces,
                                  [](const ReportTrace& trace) { return trace.group.empty(); });
    if (!choice.traces.empty()) figure.choices.push_back(std::move(choice));
    most = std::max(most, channels);
  }
  figure.caption = left_out_text(most);
  figure.chosen = figure.choices.empty() ? 0 : figure.choices.size() - 1;
  return figure;
}

/// From the second harmonic on, in % of the first.
ReportTrace overtones(const std::string& name, const std::vector<double>& harmonics, int colour) {
  ReportTrace trace{.name = name, .kind = TraceKind::kBars, .stroke = {.colour = colour}};
  for (std::size_t i = 1; i < harmonics.size(); ++i) {
    trace.x.push_back(static_cast<double>(i + 1));
    trace.y.push_back(harmonics[i] / harmonics[0] / kPercent);
  }
  return trace;
}

bool has_overtones(const std::vector<double>& harmonics) {
  return harmonics.size() > 1 && harmonics[0] > 0.0;
}

ReportFigure harmonics_figure(const ExperimentResults& results,
                              const std::vector<LevelRecord>& records, const RecordNames& names) {
  ReportFigure figure{
      .title = "Harmonics",
      .caption =
          "Amplitudes of the harmonics from the second, in percent of the "
          "first. The line is at 1 %, to which the published test held the force.",
      .x = {.label = "harmonic", .unit = "1"},
      .y = {.label = "share of the first", .unit = "%", .log = true, .log_switch = true},
      .choose = "Record",
      .wide = true};
  std::size_t most = 0;
  for (const LevelRecord& record : records) {
    // Pairs of all channels at once are hard to read: those of the force come first.
    const bool compares = std::ranges::any_of(
        record.harmonics, [](const HarmonicsPair& channel) { return !channel.other.empty(); });
    ReportChoice choice{label_of(record.source, results), {}};
    int colour = kBlue;
    double last = 2.0;
    most = std::max(most, record.harmonics.size());
    for (const HarmonicsPair& channel : record.harmonics | std::views::take(kMostChannels)) {
      const bool is_force = channel.unit == "N";
      const auto add = [&](const std::vector<double>& values, const char* name, int paint) {
        if (!has_overtones(values)) return;
        choice.traces.push_back(overtones(with(channel.name, name), values, paint));
        choice.traces.back().shown = is_force || !compares;
        last = std::max(last, choice.traces.back().x.back());
      };
      if (is_force || names.other_shown) add(channel.other, names.other, names.other_colour);
      add(channel.recorded, names.recorded, colour);
      ++colour;
      if (!channel.other.empty() && colour % kColours == names.other_colour) ++colour;
    }
    if (choice.traces.empty()) continue;
    choice.traces.push_back(one_percent(1.4, last + 0.6));
    figure.choices.push_back(std::move(choice));
  }
  figure.chosen = figure.choices.empty() ? 0 : figure.choices.size() - 1;
  figure.x.range = harmonics_range(figure.choices);
  if (most > kMostChannels) figure.caption += " " + left_out_text(most);
  return figure;
}

}  // namespace

AxisRange harmonics_range(const std::vector<ReportChoice>& choices) {
  double last = 2.0;
  for (const ReportChoice& choice : choices) {
    for (const ReportTrace& trace : choice.traces) {
      if (trace.kind == TraceKind::kBars) last = std::max(last, trace.x.back());
    }
  }
  return {1.4, last + 0.6};
}

void add_records(ReportSection& section, const ExperimentResults& results,
                 const std::vector<LevelRecord>& records, const RecordNames& names) {
  for (const std::string& unit : units_of(records)) {
    section.blocks.emplace_back(history_figure(results, records, unit, names));
  }
  ReportFigure harmonics = harmonics_figure(results, records, names);
  if (!harmonics.choices.empty()) section.blocks.emplace_back(std::move(harmonics));
}

ReportTrace one_percent(double from, double to) {
  return {.name = "1 %",
          .x = {from, to},
          .y = {1.0, 1.0},
          .stroke = {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2}};
}

}  // namespace microslip
