// SPDX-License-Identifier: MIT
#include "microslip/report/figures/rig_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/harmonic_parts.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/workflow/results/level_records.hpp"

namespace microslip {
namespace {

constexpr int kBefore = kPurple;
constexpr int kAfter = kBlue;
constexpr const char* kBeforeName = "before control";
constexpr const char* kAfterName = "after control";
constexpr const char* kOverFirst = "harmonic over the first";

std::string response_text(double response, const std::string& unit) {
  return fmt::format("{:.3g} {}", response / parse_unit(unit, kAcceleration).factor(), unit);
}

LineLayer over_force(double response, const std::vector<double>& frequency,
                     const std::vector<double>& force, std::string legend, const Stroke& stroke) {
  LineLayer line{frequency, {}, std::move(legend), stroke};
  for (const double f : force) line.y.push_back(response / f);
  return line;
}

/// The levels of the test, each near the top of its curve.
void add_measured(Figure& figure, const ExperimentResults& results) {
  if (!results.levels) return;
  const MeasuredLevels& test = *results.levels;
  if (test.frequency.empty() || test.force_amplitude.empty() || test.response_amplitude.empty()) {
    return;
  }
  PointLayer points{.x = test.frequency,
                    .y = test.response_amplitude,
                    .legend = "measured levels",
                    .colour = kBlack,
                    .size = 0.6};
  for (std::size_t i = 0; i < points.y.size(); ++i) points.y[i] /= test.force_amplitude[i];
  figure.layers.emplace_back(std::move(points));
}

Figure force_histories(const VirtualLevel& level) {
  Figure figure{.title = "Force at the highest level"};
  const auto add = [&](const DrivenVibration& driven, const char* name, int colour) {
    Curve curve = force_over_cycle(driven, 400);
    figure.layers.emplace_back(
        LineLayer{std::move(curve.x), std::move(curve.y), name, {.colour = colour}});
  };
  add(level.uncontrolled, kBeforeName, kBefore);
  add(level.controlled, kAfterName, kAfter);
  show_x(figure, "time", "s");
  show_y(figure, "force", "N");
  return figure;
}

bool has_positive(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return value > 0.0; });
}

Figure deviations_of(const std::string& channel, const std::vector<ChannelMisfit>& comparisons,
                     const FigureOptions& options) {
  PointLayer nrmse{.legend = "prediction", .colour = kBlack, .open = true};
  PointLayer noise{.legend = "noise alone", .colour = kOrange, .size = 0.6};
  for (const ChannelMisfit& row : comparisons) {
    if (row.channel != channel) continue;
    nrmse.x.push_back(row.response_amplitude);
    nrmse.y.push_back(row.nrmse);
    noise.y.push_back(row.noise_share);
  }
  noise.x = nrmse.x;
  const bool log_x = has_positive(nrmse.x);
  const bool log_y = has_positive(nrmse.y) || has_positive(noise.y);
  Figure figure{.title = channel, .layers = {std::move(noise), std::move(nrmse)}};
  show_response(figure, options, true);
  show_y(figure, "rms error over rms", "%");
  figure.x.log = figure.x.log && log_x;
  figure.y.log = log_y;
  figure.y.log_switch = true;
  return figure;
}

}  // namespace

Figure constant_response_figure(const ExperimentResults& results, const FigureOptions& options) {
  if (results.responses.empty()) {
    throw_missing("responses", "the figure needs responses of a rig with a joint");
  }
  Figure figure{
      .title = "Frequency responses at constant response",
      .caption =
          "Predicted by the identified joint in the rig. At a constant response the structure "
          "is equivalent-linear: the peak falls in frequency, and the damping rises. [AR14 Fig. "
          "4]"};
  add_measured(figure, results);
  int colour = kBlue;
  for (const ConstantResponse& response : results.responses) {
    figure.layers.emplace_back(over_force(response.response, response.frequency, response.force,
                                          response_text(response.response, options.response_unit),
                                          {.colour = colour++}));
  }
  for (const ConstantResponse& response : results.responses) {
    if (response.true_frequency.empty()) continue;
    LineLayer truth =
        over_force(response.response, response.true_frequency, response.true_force, "true joint",
                   {.colour = kBlack, .style = LineStyle::kDotted, .width = 1.2});
    truth.name = response_text(response.response, options.response_unit) + ", true joint";
    figure.layers.emplace_back(std::move(truth));
  }
  show_x(figure, "frequency", "Hz");
  show_y(figure, "acceleration over force", "m/s²/N");
  figure.y.log = figure.y.log_switch = true;
  return figure;
}

Figure force_distortion_figure(std::span<const ForceControlLevel> levels,
                               const FigureOptions& options) {
  PointLayer before{.legend = kBeforeName, .colour = kBefore};
  PointLayer after{.legend = kAfterName, .colour = kAfter};
  for (const ForceControlLevel& level : levels) {
    if (level.before.empty()) continue;
    before.x.push_back(level.response);
    before.y.push_back(std::ranges::max(level.before) / kPercent);
    after.y.push_back(std::ranges::max(level.after) / kPercent);
  }
  if (before.x.empty()) throw InputError("levels.size()", 0, "the figure needs a force control");
  after.x = before.x;
  const auto [lowest, highest] = std::ranges::minmax(before.x);
  Figure figure{.title = "Force control over the levels",
                .caption =
                    "The largest harmonic of the force from the second, in percent of the first. "
                    "[AR14 Fig. 7]",
                .y = {.label = kOverFirst, .unit = "%", .log = true, .log_switch = true},
                .layers = {one_percent(lowest, highest), std::move(before), std::move(after)}};
  show_response(figure, options, false);
  return figure;
}

Figure force_harmonics_figure(const ForceControlLevel& level) {
  BarLayer before{.legend = kBeforeName, .colour = kBefore};
  BarLayer after{.legend = kAfterName, .colour = kAfter};
  for (std::size_t i = 0; i < level.before.size(); ++i) {
    before.x.push_back(static_cast<double>(i + 2));
    before.y.push_back(level.before[i] / kPercent);
    after.y.push_back(level.after[i] / kPercent);
  }
  after.x = before.x;
  Figure figure{.title = "Harmonics of the force",
                .caption = "At one level, in percent of the first. [AR14 Fig. 7]",
                .x = harmonic_axis(2, level.before.size() + 1),
                .y = {.label = kOverFirst, .unit = "%", .log = true, .log_switch = true}};
  figure.layers = {std::move(before), std::move(after),
                   one_percent(figure.x.range->from, figure.x.range->to)};
  return figure;
}

FigureGrid force_control_figure(std::span<const ForceControlLevel> levels,
                                const FigureOptions& options) {
  Figure distortions = force_distortion_figure(levels, options);
  const ForceControlLevel& highest =
      *std::ranges::max_element(levels, {}, [](const ForceControlLevel& level) {
        return std::pair(!level.before.empty(), level.response);
      });
  Figure harmonics = force_harmonics_figure(highest);
  harmonics.title =
      "Harmonics of the force at " + response_text(highest.response, options.response_unit);
  return {"", 2, {std::move(harmonics), std::move(distortions)}};
}

FigureGrid force_control_figure(std::span<const VirtualLevel> levels, std::size_t harmonics,
                                const FigureOptions& options) {
  FigureGrid grid = force_control_figure(force_controls(levels, harmonics), options);
  grid.panels.insert(grid.panels.begin(), force_histories(levels.back()));
  grid.columns = 3;
  return grid;
}

std::vector<Figure> deviation_figures(const ExperimentResults& results,
                                      const FigureOptions& options) {
  if (results.comparisons.empty()) throw_missing("comparisons", "the figure needs a verification");
  std::vector<std::string> channels;
  std::vector<Figure> figures;
  for (const ChannelMisfit& row : results.comparisons) {
    if (std::ranges::find(channels, row.channel) != channels.end()) continue;
    channels.push_back(row.channel);
    figures.push_back(deviations_of(row.channel, results.comparisons, options));
  }
  return figures;
}

}  // namespace microslip
