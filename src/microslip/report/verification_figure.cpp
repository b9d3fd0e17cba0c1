// SPDX-License-Identifier: MIT
#include "microslip/report/verification_figure.hpp"
#include "microslip/report/scales.hpp"
#include "microslip/report/shown_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/units.hpp"
#include "microslip/report/harmonic_bars.hpp"

namespace microslip {
namespace {

constexpr std::size_t kColumns = 3;
constexpr int kRecordedColour = kBlue;
constexpr int kPredictedColour = kVermillion;

/// The lowest, a middle and the highest level.
std::vector<const Verification*> shown_records(std::span<const Verification> records) {
  std::vector<const Verification*> sorted;
  for (const Verification& record : records) sorted.push_back(&record);
  std::ranges::stable_sort(
      sorted, {}, [](const Verification* record) { return record->recorded.response_amplitude; });
  if (sorted.size() <= 3) return sorted;
  return {sorted.front(), sorted[(sorted.size() - 1) / 2], sorted.back()};
}

std::string shown_unit_of(const std::string& si) { return shown_unit(si, 1.0).text; }

std::string unit_of(const ChannelComparison& channel) {
  return shown_unit_of(si_unit(channel.dimension));
}

/// As many samples as can be told apart.
PointLayer recorded_points(const std::vector<double>& time, const std::vector<double>& recorded) {
  constexpr std::size_t kMost = 90;
  PointLayer points{.x = {}, .y = {}, .legend = "recorded", .colour = kRecordedColour, .size = 0.9};
  const std::size_t step = 1 + time.size() / kMost;
  for (std::size_t i = 0; i < time.size(); i += step) {
    points.x.push_back((time[i] - time.front()) / kMillisecond);
    points.y.push_back(recorded[i]);
  }
  return points;
}

LineLayer predicted_line() {
  return {{}, {}, "predicted", {.colour = kPredictedColour, .width = 1.6}};
}

/// Finer than the samples.
LineLayer predicted_line(const Verification& record, const ChannelComparison& channel) {
  constexpr std::size_t kPoints = 400;
  LineLayer line = predicted_line();
  const double from = record.history.front();
  const double step = (record.history.back() - from) / static_cast<double>(kPoints);
  for (std::size_t i = 0; i <= kPoints; ++i) {
    const double t = from + static_cast<double>(i) * step;
    line.x.push_back((t - from) / kMillisecond);
    line.y.push_back(channel.predicted.value(t));
  }
  return line;
}

LineLayer predicted_line(const SignalPair& signal) {
  LineLayer line = predicted_line();
  line.y = signal.other;
  for (const double t : signal.other_time) {
    line.x.push_back((t - signal.time.front()) / kMillisecond);
  }
  return line;
}

std::string level_text(double response, double frequency, const std::string& unit) {
  return fmt::format("{:.3g} {}, {:.2f} Hz", response / parse_unit(unit, kAcceleration).factor(),
                     unit, frequency);
}

/// The record without folders, where it has a name, its level and frequency.
std::string title_of(const ReducedLevel& record, const std::string& unit) {
  const std::string name = record.source.substr(record.source.find_last_of('/') + 1);
  return fmt::format("{}{}{}", name, name.empty() ? "" : ", ",
                     level_text(record.response_amplitude, record.frequency, unit));
}

std::string deviation_text(const std::string& channel, double nrmse, double noise_share) {
  return fmt::format("{}: NRMSE {}, noise alone {}", channel, percent_text(nrmse),
                     percent_text(noise_share));
}

Figure history_panel(std::string title, std::string subtitle, const std::string& label,
                     PointLayer recorded, LineLayer predicted) {
  Figure panel;
  panel.title = std::move(title);
  panel.subtitle = std::move(subtitle);
  panel.x = {.label = "time [ms]"};
  panel.y = {.label = label};
  panel.layers = {std::move(predicted), std::move(recorded)};
  panel.legend = Legend::kNone;  // that of the harmonics serves the row
  return panel;
}

Figure history_panel(const Verification& record, const ChannelComparison& channel,
                     const std::string& unit) {
  return history_panel(title_of(record.recorded, unit),
                       deviation_text(channel.name, channel.nrmse, channel.noise_share),
                       fmt::format("{} [{}]", channel.name, unit_of(channel)),
                       recorded_points(record.history, channel.recorded_history),
                       predicted_line(record, channel));
}

/// |c_n|/|c_1 recorded|, of as many n as were recorded.
std::vector<double> relative_harmonics(const ChannelComparison& channel,
                                       const FourierSeries& series) {
  const double first = std::abs(channel.recorded.c(1));
  std::vector<double> heights;
  for (std::size_t n = 1; n <= channel.recorded.order(); ++n) {
    heights.push_back(std::abs(series.c(n)) / first);
  }
  return heights;
}

/// Below it a harmonic may be noise.
LineLayer noise_line(const ChannelComparison& channel) {
  constexpr double kTelling = 3.0;
  LineLayer line{
      {}, {}, "3 standard errors", {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2}};
  const double first = std::abs(channel.recorded.c(1));
  for (std::size_t n = 1; n <= channel.recorded.order(); ++n) {
    line.x.push_back(static_cast<double>(n));
    line.y.push_back(kTelling * channel.recorded_std[n - 1] / first);
  }
  return line;
}

/// @param recorded, predicted  over the first one recorded. @param lowest  shown.
Figure harmonics_panel(const std::string& channel, const std::vector<double>& recorded,
                       const std::vector<double>& predicted, double lowest) {
  Figure panel;
  panel.title = fmt::format("Harmonics of {}", channel);
  panel.subtitle = "relative to the first one recorded";
  panel.x = harmonic_axis(recorded.size());
  panel.y = {.label = "amplitude [1]",
             .log = true,
             .range = AxisRange{std::clamp(0.3 * lowest, 1e-9, 0.01), 30.0}};
  add_harmonic_bars(panel, recorded, BarSide::kLeft, kRecordedColour, "recorded");
  add_harmonic_bars(panel, predicted, BarSide::kRight, kPredictedColour, "predicted");
  panel.legend = Legend::kTopRight;
  return panel;
}

Figure harmonics_panel(const ChannelComparison& channel) {
  const double noise =
      *std::ranges::min_element(channel.recorded_std) / std::abs(channel.recorded.c(1));
  Figure panel = harmonics_panel(channel.name, relative_harmonics(channel, channel.recorded),
                                 relative_harmonics(channel, channel.predicted), noise);
  panel.layers.emplace_back(noise_line(channel));
  return panel;
}

/// The comparisons of a record; nothing where the files do not tell.
const ChannelMisfit* comparison_of(const ExperimentResults& results, const std::string& source,
                                   const std::string& channel) {
  for (const ChannelMisfit& row : results.comparisons) {
    if (row.source == source && row.channel == channel) return &row;
  }
  return nullptr;
}

/// The lowest, a middle and the highest level.
std::vector<const LevelRecord*> shown_records(const ExperimentResults& results) {
  std::vector<std::pair<double, const LevelRecord*>> sorted;
  for (const LevelRecord& record : results.predictions) {
    if (record.signals.empty()) continue;
    const ChannelMisfit* row = comparison_of(results, record.source, record.signals.front().name);
    sorted.emplace_back(row == nullptr ? 0.0 : row->response_amplitude, &record);
  }
  std::ranges::stable_sort(sorted, {}, [](const auto& entry) { return entry.first; });
  std::vector<const LevelRecord*> shown;
  for (const auto& [response, record] : sorted) shown.push_back(record);
  if (shown.size() <= 3) return shown;
  return {shown.front(), shown[(shown.size() - 1) / 2], shown.back()};
}

/// The force, where there is one, and the first acceleration.
std::vector<const SignalPair*> shown_signals(const LevelRecord& record) {
  std::vector<const SignalPair*> shown;
  for (const std::string unit : {"N", "m/s^2"}) {
    const auto found = std::ranges::find(record.signals, unit, &SignalPair::unit);
    if (found != record.signals.end()) shown.push_back(&*found);
  }
  if (shown.empty()) shown.push_back(&record.signals.front());
  return shown;
}

Figure history_panel(const ExperimentResults& results, const LevelRecord& record,
                     const SignalPair& signal) {
  const ChannelMisfit* row = comparison_of(results, record.source, signal.name);
  Figure panel = history_panel(
      row == nullptr ? record.source : level_text(row->response_amplitude, row->frequency, "m/s²"),
      row == nullptr ? "" : "NRMSE " + percent_text(row->nrmse),
      fmt::format("{} [{}]", signal.name, shown_unit_of(signal.unit)),
      recorded_points(signal.time, signal.recorded), predicted_line(signal));
  panel.legend = Legend::kBelow;
  return panel;
}

std::optional<Figure> harmonics_panel(const LevelRecord& record, const std::string& channel) {
  const auto found = std::ranges::find(record.harmonics, channel, &HarmonicsPair::name);
  if (found == record.harmonics.end() || found->recorded.empty() ||
      !(found->recorded.front() > 0.0)) {
    return std::nullopt;
  }
  std::vector<double> recorded = found->recorded;
  std::vector<double> predicted = found->other;
  const double first = found->recorded.front();
  for (auto* values : {&recorded, &predicted}) {
    for (double& value : *values) value /= first;
  }
  Figure panel = harmonics_panel(channel, recorded, predicted, std::ranges::min(recorded));
  panel.subtitle.clear();
  panel.y.label = "over the first recorded [1]";
  panel.legend = Legend::kBelow;
  return panel;
}

}  // namespace

FigureGrid verification_figure(std::span<const Verification> records, const std::string& unit) {
  FigureGrid figure;
  figure.title = "Recorded and predicted response";
  figure.columns = kColumns;
  for (const Verification* record : shown_records(records)) {
    const ChannelComparison& acceleration = record->channels[record->drive_point.value_or(1)];
    figure.panels.push_back(history_panel(*record, record->channels.front(), unit));
    figure.panels.push_back(history_panel(*record, acceleration, unit));
    figure.panels.push_back(harmonics_panel(acceleration));
  }
  return figure;
}

FigureGrid verification_figure(const ExperimentResults& results) {
  FigureGrid figure;
  for (const LevelRecord* record : shown_records(results)) {
    const std::size_t before = figure.panels.size();
    const std::vector<const SignalPair*> signals = shown_signals(*record);
    for (const SignalPair* signal : signals) {
      figure.panels.push_back(history_panel(results, *record, *signal));
    }
    if (auto harmonics = harmonics_panel(*record, signals.back()->name)) {
      figure.panels.push_back(std::move(*harmonics));
    }
    figure.columns = figure.panels.size() - before;
  }
  if (!figure.panels.empty()) return figure;
  throw InputError("predictions.size()", 0, "the figure needs histories of a verification");
}

PictureSize verification_size(const FigureGrid& figure) {
  constexpr int kWidth = 1320;
  constexpr int kRow = 320;
  const auto rows = static_cast<int>((figure.panels.size() + kColumns - 1) / kColumns);
  return {kWidth, 40 + kRow * rows};
}

}  // namespace microslip
