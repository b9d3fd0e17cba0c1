// SPDX-License-Identifier: MIT
#include "microslip/report/verification_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/report/harmonic_bars.hpp"

namespace microslip {
namespace {

constexpr double kMillisecond = 1e-3;
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

std::string unit_of(const ChannelComparison& channel) {
  return channel.dimension == kAcceleration ? "m/s²" : si_unit(channel.dimension);
}

/// As many samples as can be told apart.
PointLayer recorded_points(const Verification& record, const ChannelComparison& channel) {
  constexpr std::size_t kMost = 90;
  PointLayer points{.x = {}, .y = {}, .legend = "recorded", .colour = kRecordedColour, .size = 0.9};
  const std::size_t step = 1 + record.history.size() / kMost;
  for (std::size_t i = 0; i < record.history.size(); i += step) {
    points.x.push_back((record.history[i] - record.history.front()) / kMillisecond);
    points.y.push_back(channel.recorded_history[i]);
  }
  return points;
}

/// Finer than the samples.
LineLayer predicted_line(const Verification& record, const ChannelComparison& channel) {
  constexpr std::size_t kPoints = 400;
  LineLayer line{{}, {}, "predicted", {.colour = kPredictedColour, .width = 1.6}};
  const double from = record.history.front();
  const double step = (record.history.back() - from) / static_cast<double>(kPoints);
  for (std::size_t i = 0; i <= kPoints; ++i) {
    const double t = from + static_cast<double>(i) * step;
    line.x.push_back((t - from) / kMillisecond);
    line.y.push_back(channel.predicted.value(t));
  }
  return line;
}

/// The record without folders, where it has a name, its level and frequency.
std::string title_of(const ReducedLevel& record, const std::string& unit) {
  const std::string name = record.source.substr(record.source.find_last_of('/') + 1);
  return fmt::format("{}{}{:.3g} {}, {:.2f} Hz", name, name.empty() ? "" : ", ",
                     record.response_amplitude / parse_unit(unit, kAcceleration).factor(), unit,
                     record.frequency);
}

Figure history_panel(const Verification& record, const ChannelComparison& channel,
                     const std::string& unit) {
  Figure panel;
  panel.title = title_of(record.recorded, unit);
  panel.subtitle = fmt::format("{}: NRMSE {:.3g} %, noise alone {:.3g} %", channel.name,
                               100.0 * channel.nrmse, 100.0 * channel.noise_share);
  panel.x = {.label = "time [ms]"};
  panel.y = {.label = fmt::format("{} [{}]", channel.name, unit_of(channel))};
  panel.layers = {predicted_line(record, channel), recorded_points(record, channel)};
  panel.legend = Legend::kNone;  // that of the harmonics serves the row
  return panel;
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

Figure harmonics_panel(const ChannelComparison& channel) {
  Figure panel;
  panel.title = fmt::format("Harmonics of {}", channel.name);
  panel.subtitle = "relative to the first one recorded";
  panel.x = harmonic_axis(channel.recorded.order());
  const double noise =
      *std::ranges::min_element(channel.recorded_std) / std::abs(channel.recorded.c(1));
  panel.y = {.label = "amplitude [1]",
             .log = true,
             .range = AxisRange{std::clamp(0.3 * noise, 1e-9, 0.01), 30.0}};
  add_harmonic_bars(panel, relative_harmonics(channel, channel.recorded), BarSide::kLeft,
                    kRecordedColour, "recorded");
  add_harmonic_bars(panel, relative_harmonics(channel, channel.predicted), BarSide::kRight,
                    kPredictedColour, "predicted");
  panel.layers.emplace_back(noise_line(channel));
  panel.legend = Legend::kTopRight;
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

PictureSize verification_size(const FigureGrid& figure) {
  constexpr int kWidth = 1320;
  constexpr int kRow = 320;
  const auto rows = static_cast<int>((figure.panels.size() + kColumns - 1) / kColumns);
  return {kWidth, 40 + kRow * rows};
}

}  // namespace microslip
