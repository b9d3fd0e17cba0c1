// SPDX-License-Identifier: MIT
#include "microslip/report/figures/record_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <string_view>
#include <utility>

#include "microslip/report/document/harmonic_parts.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/report/document/shown_unit.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostChannels = 8;  // of a figure: as many as there are colours

std::string with(const std::string& name, std::string_view which) {
  return which.empty() ? name : fmt::format("{}, {}", name, which);
}

/// Unit of a signal and its size: displacements of a joint are in micrometres.
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

/// Layers of a record: the other ones are in front of all recorded ones.
struct SignalLayers {
  std::vector<Layer> recorded;
  std::vector<Layer> other;
};

/// The two curves of a signal.
void add_signal(const SignalPair& signal, const RecordNames& names, int colour, double scale,
                SignalLayers& layers) {
  const bool compares = !signal.other.empty();
  layers.recorded.emplace_back(
      LineLayer{.x = in_unit(signal.time, kMillisecond),
                .y = in_unit(signal.recorded, scale),
                .legend = with(signal.name, names.recorded),
                .stroke = {.colour = colour, .width = compares && names.other_shown ? 3.2 : 1.6}});
  if (!compares) return;
  layers.other.emplace_back(
      LineLayer{.x = in_unit(signal.other_time, kMillisecond),
                .y = in_unit(signal.other, scale),
                .legend = names.other,
                .stroke = {.colour = names.other_colour, .style = LineStyle::kDashed, .width = 1.2},
                .name = with(signal.name, names.other),
                .shown = names.other_shown || signal.unit == "N"});
}

/// "8 of the 200 channels are shown.", where a record has more than a figure shows.
std::string left_out_text(std::size_t channels) {
  if (channels <= kMostChannels) return {};
  return fmt::format("The first {} of the {} channels of the record are shown.", kMostChannels,
                     channels);
}

/// The signals of one unit, a choice per record.
ReportFigure history_figure(const ExperimentResults& results,
                            const std::vector<LevelRecord>& records, const std::string& unit,
                            const RecordNames& names) {
  const auto [shown, scale] = unit_of_signal(unit);
  std::string title = quantity_of_unit(unit);
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  ReportFigure figure{.figure = {.title = title + " over time",
                                 .x = {.label = "time", .unit = "ms"},
                                 .y = {.label = quantity_of_unit(unit), .unit = shown}},
                      .chart = ChartKind::kTimeHistory,
                      .choose = "Record",
                      .wide = true};
  std::size_t most = 0;
  for (const LevelRecord& record : records) {
    SignalLayers layers;
    int colour = kBlue;
    std::size_t channels = 0;
    for (const SignalPair& signal : record.signals) {
      if (signal.unit != unit || ++channels > kMostChannels) continue;
      add_signal(signal, names, colour, scale, layers);
      ++colour;
      if (!signal.other.empty() && colour % kColours == names.other_colour) ++colour;
    }
    std::ranges::move(layers.other, std::back_inserter(layers.recorded));
    if (!layers.recorded.empty()) {
      figure.choices.push_back({label_of(record.source, results), std::move(layers.recorded)});
    }
    most = std::max(most, channels);
  }
  figure.figure.caption = left_out_text(most);
  figure.chosen = figure.choices.empty() ? 0 : figure.choices.size() - 1;
  return figure;
}

/// Bars from the second harmonic on, in % of the first.
BarLayer overtones(std::string name, const std::vector<double>& harmonics, int colour) {
  BarLayer bars{.legend = std::move(name), .colour = colour};
  for (std::size_t i = 1; i < harmonics.size(); ++i) {
    bars.x.push_back(static_cast<double>(i + 1));
    bars.y.push_back(harmonics[i] / harmonics[0] / kPercent);
  }
  return bars;
}

bool has_overtones(const std::vector<double>& harmonics) {
  return harmonics.size() > 1 && harmonics[0] > 0.0;
}

ReportFigure harmonics_figure(const ExperimentResults& results,
                              const std::vector<LevelRecord>& records, const RecordNames& names) {
  ReportFigure figure{
      .figure =
          {.title = "Harmonics",
           .caption = "Amplitudes of the harmonics from the second, in percent of the "
                      "first. The line is at 1 %, the limit of the published test.",
           .y = {.label = "share of the first", .unit = "%", .log = true, .log_switch = true}},
      .choose = "Record",
      .wide = true};
  std::size_t last = 2;  // harmonic
  std::size_t most = 0;
  for (const LevelRecord& record : records) {
    // Pairs of all channels at once are hard to read: those of the force come first.
    const bool compares = std::ranges::any_of(
        record.harmonics, [](const HarmonicsPair& channel) { return !channel.other.empty(); });
    FigureChoice choice{label_of(record.source, results), {}};
    int colour = kBlue;
    most = std::max(most, record.harmonics.size());
    for (const HarmonicsPair& channel : record.harmonics | std::views::take(kMostChannels)) {
      const bool is_force = channel.unit == "N";
      const auto add = [&](const std::vector<double>& values, const char* name, int paint) {
        if (!has_overtones(values)) return;
        BarLayer bars = overtones(with(channel.name, name), values, paint);
        bars.shown = is_force || !compares;
        last = std::max(last, values.size());
        choice.layers.emplace_back(std::move(bars));
      };
      if (is_force || names.other_shown) add(channel.other, names.other, names.other_colour);
      add(channel.recorded, names.recorded, colour);
      ++colour;
      if (!channel.other.empty() && colour % kColours == names.other_colour) ++colour;
    }
    if (!choice.layers.empty()) figure.choices.push_back(std::move(choice));
  }
  figure.figure.x = harmonic_axis(2, last);
  const AxisRange range = *figure.figure.x.range;
  for (FigureChoice& choice : figure.choices) {
    choice.layers.emplace_back(one_percent(range.from, range.to));
  }
  figure.chosen = figure.choices.empty() ? 0 : figure.choices.size() - 1;
  if (most > kMostChannels) figure.figure.caption += " " + left_out_text(most);
  return figure;
}

}  // namespace

void add_records(ReportSection& section, const ExperimentResults& results,
                 const std::vector<LevelRecord>& records, const RecordNames& names) {
  for (const std::string& unit : units_of(records)) {
    section.blocks.emplace_back(history_figure(results, records, unit, names));
  }
  ReportFigure harmonics = harmonics_figure(results, records, names);
  if (!harmonics.choices.empty()) section.blocks.emplace_back(std::move(harmonics));
}

}  // namespace microslip
