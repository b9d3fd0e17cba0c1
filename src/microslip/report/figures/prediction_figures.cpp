// SPDX-License-Identifier: MIT
#include "microslip/report/figures/prediction_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"

namespace microslip {
namespace {

constexpr const char* kOfDraws = "band of draws";

/// "slip_force" in words of an axis.
std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

LineLayer line_of(const std::vector<double>& x, const std::vector<double>& y) {
  return {x, y, "", {.colour = kBlue}};
}

Figure panel_of(const std::vector<double>& x, const std::vector<double>& y) {
  Figure panel;
  panel.layers = {line_of(x, y)};
  check_figure(panel);
  return panel;
}

/// The band behind a curve. A curve that turns back has one for each part between two turns, since
/// each is an area between two lines over x.
void add_curve_band(Figure& panel, const std::vector<double>& x, const CurveBand& band) {
  if (band.lower.empty()) return;
  std::vector<Layer> parts;
  for (std::size_t from = 0; from + 1 < x.size();) {
    std::size_t to = from + 1;
    while (to + 1 < x.size() && (x[to] - x[to - 1]) * (x[to + 1] - x[to]) >= 0.0) ++to;
    const auto part = [&](const std::vector<double>& values) {
      return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(from),
                                 values.begin() + static_cast<std::ptrdiff_t>(to + 1));
    };
    parts.emplace_back(BandLayer{part(x), part(band.lower), part(band.upper), kOfDraws, kBlue});
    from = to;
  }
  panel.layers.insert(panel.layers.begin(), parts.begin(), parts.end());
}

std::vector<double> receptance_of(const std::vector<double>& displacement,
                                  const std::vector<double>& force) {
  std::vector<double> receptance = displacement;
  for (std::size_t i = 0; i < receptance.size(); ++i) receptance[i] /= force.at(i);
  return receptance;
}

/// The band of the receptance: its lower edge is at the upper edge of the force.
CurveBand receptance_of(const PredictedResponse& response) {
  if (response.band.lower.empty()) return {};
  return {receptance_of(response.displacement, response.band.upper),
          receptance_of(response.displacement, response.band.lower)};
}

/// The phase without jumps of a whole turn from −π to π.
std::vector<double> continuous(std::vector<double> phase) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (std::size_t i = 1; i < phase.size(); ++i) {
    phase[i] -= kTurn * std::round((phase[i] - phase[i - 1]) / kTurn);
  }
  return phase;
}

Figure over_amplitude(const std::vector<double>& amplitude, const std::vector<double>& values,
                      const CurveBand& band, bool log, std::string_view x_label) {
  Figure panel = panel_of(amplitude, values);
  add_curve_band(panel, amplitude, band);
  show_x(panel, x_label, "m");
  panel.x.log = log;
  return panel;
}

/// A logarithmic axis suits amplitudes that reach over more than a decade and a half.
bool reaches_far(const std::vector<double>& amplitude) {
  constexpr double kFar = 30.0;
  if (amplitude.empty()) return false;
  const auto [lowest, highest] = std::ranges::minmax(amplitude);
  return lowest > 0.0 && highest > kFar * lowest;
}

/// The signal by the lowest and the highest of each part, in their order, with the widest band.
HistorySignal thinned(const HistorySignal& signal) {
  constexpr std::size_t kParts = 2000;
  if (signal.values.size() <= 2 * kParts) return signal;
  HistorySignal thin{signal.name, signal.quantity, signal.unit, {}, {}};
  const bool has_band = !signal.band.lower.empty();
  const std::size_t count = signal.values.size();
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto begin = signal.values.begin() + static_cast<std::ptrdiff_t>(part * count / kParts);
    const auto end =
        signal.values.begin() + static_cast<std::ptrdiff_t>((part + 1) * count / kParts);
    auto [low, high] = std::minmax_element(begin, end);
    if (high < low) std::swap(low, high);
    const auto [from, to] = std::pair{begin - signal.values.begin(), end - signal.values.begin()};
    for (const auto at : {low, high}) {
      thin.time.push_back(signal.time.at(static_cast<std::size_t>(at - signal.values.begin())));
      thin.values.push_back(*at);
      if (!has_band) continue;
      thin.band.lower.push_back(
          *std::min_element(signal.band.lower.begin() + from, signal.band.lower.begin() + to));
      thin.band.upper.push_back(
          *std::max_element(signal.band.upper.begin() + from, signal.band.upper.begin() + to));
    }
  }
  return thin;
}

/// A quantity in a unit, which shares an axis.
using AxisOfSignals = std::pair<std::string, std::string>;

AxisOfSignals axis_of(const HistorySignal& signal) {
  return {signal.quantity.empty() ? quantity_of_unit(signal.unit) : signal.quantity, signal.unit};
}

Figure history_panel(std::span<const HistorySignal> signals, const AxisOfSignals& axis) {
  const auto& [quantity, unit] = axis;
  Figure panel;
  std::vector<Layer> bands;
  for (const HistorySignal& signal : signals) {
    if (axis_of(signal) != axis) continue;
    const HistorySignal thin = thinned(signal);
    const auto colour = static_cast<int>(panel.layers.size());
    if (!thin.band.lower.empty()) {
      bands.emplace_back(BandLayer{thin.time, thin.band.lower, thin.band.upper, kOfDraws, colour});
    }
    panel.layers.emplace_back(
        LineLayer{thin.time, thin.values, signal.name, {.colour = colour, .width = 1.4}});
  }
  // One signal is named by the axis.
  if (panel.layers.size() == 1) std::get<LineLayer>(panel.layers.front()).legend.clear();
  panel.layers.insert(panel.layers.begin(), bands.begin(), bands.end());
  check_figure(panel);
  show_x(panel, "time", "s");
  show_y(panel, quantity, unit.empty() ? "?" : unit);
  return panel;
}

}  // namespace

FigureGrid response_figure(const PredictedResponse& response) {
  const bool at_force = is_same_all_along(response.force);
  Figure amplitude =
      panel_of(response.frequency, at_force ? response.displacement
                                            : receptance_of(response.displacement, response.force));
  add_curve_band(amplitude, response.frequency, at_force ? response.band : receptance_of(response));
  Figure phase = panel_of(response.frequency, continuous(response.phase));
  show_x(amplitude, "frequency", "Hz");
  show_x(phase, "frequency", "Hz");
  if (at_force) {
    show_y(amplitude, response.shaken ? "amplitude relative to the base" : "displacement amplitude",
           "m");
  } else if (response.shaken) {
    show_y(amplitude, "displacement over base acceleration", "s²");
  } else {
    show_y(amplitude, "displacement over force", "m/N");
  }
  show_y(phase, "phase lag", "°");
  amplitude.y.log = true;
  phase.y.degrees = true;
  return {"", 1, {std::move(amplitude), std::move(phase)}};
}

Figure spectrum_figure(const ShockSpectrum& spectrum) {
  Figure figure;
  const auto add = [&](const std::vector<double>& values, const char* legend,
                       const Stroke& stroke) {
    // A logarithmic axis has no place for a direction in which nothing moves.
    if (std::ranges::all_of(values, [](double value) { return value > 0.0; })) {
      figure.layers.emplace_back(LineLayer{spectrum.frequency, values, legend, stroke});
    }
  };
  add(spectrum.maximax, "maximax", {.colour = kBlue, .width = 2.4});
  add(spectrum.positive, "positive", {.colour = kVermillion, .style = LineStyle::kDashed});
  add(spectrum.negative, "negative", {.colour = kGreen, .style = LineStyle::kDotted});
  if (figure.layers.empty()) {
    throw InputError("maximax", 0.0, "must be above 0 at all frequencies, to be drawn");
  }
  check_figure(figure);
  show_x(figure, "natural frequency", "Hz");
  show_y(figure, "largest acceleration", "m/s²");
  figure.x.log = figure.y.log = true;
  return figure;
}

FigureGrid backbone_figure(const PredictedBackbone& backbone, const FigureOptions& options) {
  const bool log = is_log(options, reaches_far(backbone.displacement));
  constexpr const char* kLabel = "displacement amplitude";
  Figure frequency = over_amplitude(backbone.displacement, backbone.frequency,
                                    backbone.frequency_band, log, kLabel);
  Figure damping = over_amplitude(backbone.displacement, backbone.damping_ratio,
                                  backbone.damping_band, log, kLabel);
  show_y(frequency, "resonance frequency", "Hz");
  show_y(damping, "damping ratio ζ", "%");
  return {"", 2, {std::move(frequency), std::move(damping)}};
}

FigureGrid joint_figures(const DissipationCurve& curve, const FigureOptions& options) {
  const bool log = is_log(options, reaches_far(curve.amplitude));
  constexpr const char* kLabel = "joint amplitude A";
  Figure energy =
      over_amplitude(curve.amplitude, curve.dissipation, curve.dissipation_band, log, kLabel);
  Figure secant =
      over_amplitude(curve.amplitude, curve.secant_stiffness, curve.secant_band, log, kLabel);
  Figure loss = over_amplitude(curve.amplitude, curve.loss_factor, curve.loss_band, log, kLabel);
  show_y(energy, "dissipation per cycle D", "J");
  show_y(secant, "secant stiffness k_eq", "N/m");
  show_y(loss, "loss factor η", "1");
  energy.y.log = log;
  return {"", 3, {std::move(energy), std::move(secant), std::move(loss)}};
}

FigureGrid histories_figure(std::span<const HistorySignal> signals) {
  std::vector<AxisOfSignals> axes;
  for (const HistorySignal& signal : signals) {
    if (std::ranges::find(axes, axis_of(signal)) == axes.end()) axes.push_back(axis_of(signal));
  }
  if (axes.empty()) throw InputError("signals.size()", 0, "a history needs a signal");
  FigureGrid grid{"", 1, {}};
  for (const AxisOfSignals& axis : axes) grid.panels.push_back(history_panel(signals, axis));
  constexpr std::size_t kMostStacked = 3;
  if (grid.panels.size() > kMostStacked) grid.columns = 2;
  return grid;
}

Figure path_figure(const std::vector<double>& displacement, const std::vector<double>& force,
                   const CurveBand& band) {
  Figure figure = panel_of(displacement, force);
  add_curve_band(figure, displacement, band);
  show_x(figure, "joint displacement", "m");
  show_y(figure, "joint force", "N");
  return figure;
}

bool is_curve(const EnsembleCurve& curve) {
  constexpr std::size_t kFewest = 4;
  return curve.at.size() >= kFewest;
}

FigureGrid ensemble_figure(std::span<const EnsembleCurve> curves) {
  FigureGrid grid{.title = "", .columns = 2, .panels = {}};
  const bool one_group = std::ranges::all_of(
      curves, [&](const EnsembleCurve& curve) { return curve.group == curves.front().group; });
  for (const EnsembleCurve& curve : curves) {
    if (!is_curve(curve)) continue;
    Figure panel = panel_of(curve.at, curve.median);
    std::get<LineLayer>(panel.layers.front()).legend = "median";
    add_curve_band(panel, curve.at, curve.band);
    show_x(panel, words_of(curve.axis), curve.axis_unit);
    show_y(panel, words_of(curve.output), curve.unit);
    if (!one_group) panel.title = curve.group;
    grid.panels.push_back(std::move(panel));
  }
  if (grid.panels.empty()) {
    throw InputError("curves of the ensemble", "missing", "must be there: it has numbers alone");
  }
  return grid;
}

}  // namespace microslip
