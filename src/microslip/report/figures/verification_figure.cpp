// SPDX-License-Identifier: MIT
#include "microslip/report/figures/verification_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/units.hpp"
#include "microslip/report/document/harmonic_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"

namespace microslip {
namespace {

constexpr int kRecordedColour = kBlue;
constexpr int kPredictedColour = kVermillion;

/// Largest number of samples that can be distinguished.
PointLayer recorded_points(const SignalPair& signal) {
  constexpr std::size_t kMost = 90;
  PointLayer points{.legend = "recorded", .colour = kRecordedColour, .size = 0.9};
  const std::size_t step = 1 + signal.time.size() / kMost;
  for (std::size_t i = 0; i < signal.time.size(); i += step) {
    points.x.push_back(signal.time[i] - signal.time.front());
    points.y.push_back(signal.recorded[i]);
  }
  return points;
}

LineLayer predicted_line(const SignalPair& signal) {
  LineLayer line{.y = signal.other,
                 .legend = "predicted",
                 .stroke = {.colour = kPredictedColour, .width = 1.6}};
  for (const double t : signal.other_time) line.x.push_back(t - signal.time.front());
  return line;
}

/// The comparisons of a record; nothing where the files do not have them.
const ChannelMisfit* comparison_of(const ExperimentResults& results, const std::string& source,
                                   const std::string& channel) {
  for (const ChannelMisfit& row : results.comparisons) {
    if (row.source == source && row.channel == channel) return &row;
  }
  return nullptr;
}

/// Title with level and frequency, where they are known, and else the record.
std::string title_of(const std::string& source, const ChannelMisfit* row, const std::string& unit) {
  if (row == nullptr) return std::string(file_name(source));
  return fmt::format("{:.3g} {}, {:.2f} Hz",
                     row->response_amplitude / parse_unit(unit, kAcceleration).factor(), unit,
                     row->frequency);
}

std::string subtitle_of(const ChannelMisfit* row) {
  if (row == nullptr) return {};
  return fmt::format("NRMSE {}, noise {}", percent_text(row->nrmse),
                     percent_text(row->noise_share));
}

/// The records of the lowest, a middle and the highest level.
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
                     const SignalPair& signal, const FigureOptions& options) {
  const ChannelMisfit* row = comparison_of(results, record.source, signal.name);
  Figure panel{.title = title_of(record.source, row, options.response_unit),
               .subtitle = subtitle_of(row),
               .layers = {predicted_line(signal), recorded_points(signal)}};
  show_x(panel, "time", "s");
  panel.y = {.label = signal.name, .unit = shown_unit(signal.unit, 1.0).text};
  return panel;
}

/// Line below which a harmonic may be noise.
LineLayer noise_line(const HarmonicsPair& harmonics) {
  constexpr double kSignificant = 3.0;
  LineLayer line{.legend = "3 standard errors",
                 .stroke = {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2}};
  for (std::size_t i = 0; i < harmonics.recorded_std.size(); ++i) {
    line.x.push_back(static_cast<double>(i + 1));
    line.y.push_back(kSignificant * harmonics.recorded_std[i] / harmonics.recorded.front());
  }
  return line;
}

BarLayer bars_of(const std::vector<double>& harmonics, double first, const char* legend,
                 int colour) {
  BarLayer bars{.legend = legend, .colour = colour};
  for (std::size_t i = 0; i < harmonics.size(); ++i) {
    bars.x.push_back(static_cast<double>(i + 1));
    bars.y.push_back(harmonics[i] / first);
  }
  return bars;
}

std::optional<Figure> harmonics_panel(const LevelRecord& record, const std::string& channel) {
  const auto found = std::ranges::find(record.harmonics, channel, &HarmonicsPair::name);
  if (found == record.harmonics.end() || found->recorded.empty() ||
      !(found->recorded.front() > 0.0)) {
    return std::nullopt;
  }
  const double first = found->recorded.front();
  const auto& recorded = found->recorded_std.empty() ? found->recorded : found->recorded_std;
  const double lowest = std::clamp(0.3 * std::ranges::min(recorded) / first, 1e-9, 0.01);
  Figure panel{.title = "Harmonics of " + channel,
               .subtitle = std::string(file_name(record.source)),
               .x = harmonic_axis(1, found->recorded.size()),
               .y = {.label = "over the first recorded",
                     .unit = "1",
                     .log = true,
                     .range = AxisRange{lowest, 30.0}},
               .layers = {bars_of(found->recorded, first, "recorded", kRecordedColour),
                          bars_of(found->other, first, "predicted", kPredictedColour)}};
  if (!found->recorded_std.empty()) panel.layers.emplace_back(noise_line(*found));
  return panel;
}

}  // namespace

FigureGrid verification_figure(const ExperimentResults& results, const FigureOptions& options) {
  FigureGrid figure;
  for (const LevelRecord* record : shown_records(results)) {
    const std::size_t before = figure.panels.size();
    const std::vector<const SignalPair*> signals = shown_signals(*record);
    for (const SignalPair* signal : signals) {
      figure.panels.push_back(history_panel(results, *record, *signal, options));
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
  constexpr int kRow = 340;
  const auto rows = static_cast<int>((figure.panels.size() + figure.columns - 1) / figure.columns);
  return {kWidth, 40 + kRow * rows};
}

}  // namespace microslip
