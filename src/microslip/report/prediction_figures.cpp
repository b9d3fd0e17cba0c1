// SPDX-License-Identifier: MIT
#include "microslip/report/prediction_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/report/figure_parts.hpp"
#include "microslip/report/shown_unit.hpp"

namespace microslip {
namespace {

LineLayer line_of(const std::vector<double>& x, const std::vector<double>& y) {
  return {x, y, "", {.colour = kBlue}};
}

Figure panel_of(const std::vector<double>& x, const std::vector<double>& y) {
  Figure panel;
  panel.layers = {line_of(x, y)};
  check_figure(panel);
  return panel;
}

/// The force is the same all along but for what a solver leaves.
bool is_constant(const std::vector<double>& values) {
  constexpr double kSame = 1e-6;
  if (values.empty()) return true;
  const auto [lowest, highest] = std::ranges::minmax(values);
  return highest - lowest <= kSame * highest;
}

std::vector<double> over_force(const PredictedResponse& response) {
  std::vector<double> receptance = response.displacement;
  for (std::size_t i = 0; i < receptance.size(); ++i) receptance[i] /= response.force.at(i);
  return receptance;
}

/// Without the steps of a whole turn from −π to π.
std::vector<double> continuous(std::vector<double> phase) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (std::size_t i = 1; i < phase.size(); ++i) {
    phase[i] -= kTurn * std::round((phase[i] - phase[i - 1]) / kTurn);
  }
  return phase;
}

Figure over_amplitude(const std::vector<double>& amplitude, const std::vector<double>& values,
                      bool log, std::string_view x_label) {
  Figure panel = panel_of(amplitude, values);
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

/// The lowest and the highest of each part, in their order.
HistorySignal thinned(const HistorySignal& signal) {
  constexpr std::size_t kParts = 2000;
  if (signal.values.size() <= 2 * kParts) return signal;
  HistorySignal thin{signal.name, signal.quantity, signal.unit, {}, {}};
  const std::size_t count = signal.values.size();
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto begin = signal.values.begin() + static_cast<std::ptrdiff_t>(part * count / kParts);
    const auto end =
        signal.values.begin() + static_cast<std::ptrdiff_t>((part + 1) * count / kParts);
    auto [low, high] = std::minmax_element(begin, end);
    if (high < low) std::swap(low, high);
    for (const auto at : {low, high}) {
      thin.time.push_back(signal.time.at(static_cast<std::size_t>(at - signal.values.begin())));
      thin.values.push_back(*at);
    }
  }
  return thin;
}

/// What shares an axis: a quantity in a unit.
using AxisOfSignals = std::pair<std::string, std::string>;

AxisOfSignals axis_of(const HistorySignal& signal) {
  return {signal.quantity.empty() ? quantity_of_unit(signal.unit) : signal.quantity, signal.unit};
}

Figure history_panel(std::span<const HistorySignal> signals, const AxisOfSignals& axis) {
  const auto& [quantity, unit] = axis;
  Figure panel;
  for (const HistorySignal& signal : signals) {
    if (axis_of(signal) != axis) continue;
    const HistorySignal thin = thinned(signal);
    panel.layers.emplace_back(
        LineLayer{thin.time,
                  thin.values,
                  signal.name,
                  {.colour = static_cast<int>(panel.layers.size()), .width = 1.4}});
  }
  check_figure(panel);
  // One signal is named by the axis.
  if (panel.layers.size() == 1) std::get<LineLayer>(panel.layers.front()).legend.clear();
  show_x(panel, "time", "s");
  show_y(panel, quantity, unit.empty() ? "?" : unit);
  return panel;
}

}  // namespace

FigureGrid response_figure(const PredictedResponse& response) {
  Figure amplitude = is_constant(response.force)
                         ? panel_of(response.frequency, response.displacement)
                         : panel_of(response.frequency, over_force(response));
  Figure phase = panel_of(response.frequency, continuous(response.phase));
  show_x(amplitude, "frequency", "Hz");
  show_x(phase, "frequency", "Hz");
  if (is_constant(response.force)) {
    show_y(amplitude, "displacement amplitude", "m");
  } else {
    show_y(amplitude, "displacement over force", "m/N");
  }
  show_y(phase, "phase lag", "°");
  amplitude.y.log = true;
  phase.y.degrees = true;
  return {"", 1, {std::move(amplitude), std::move(phase)}};
}

FigureGrid backbone_figure(const PredictedBackbone& backbone, const FigureOptions& options) {
  const bool log = is_log(options, reaches_far(backbone.displacement));
  constexpr const char* kLabel = "displacement amplitude";
  Figure frequency = over_amplitude(backbone.displacement, backbone.frequency, log, kLabel);
  Figure damping = over_amplitude(backbone.displacement, backbone.damping_ratio, log, kLabel);
  show_y(frequency, "resonance frequency", "Hz");
  show_y(damping, "damping ratio ζ", "%");
  return {"", 2, {std::move(frequency), std::move(damping)}};
}

FigureGrid joint_figures(const DissipationCurve& curve, const FigureOptions& options) {
  const bool log = is_log(options, reaches_far(curve.amplitude));
  constexpr const char* kLabel = "joint amplitude A";
  Figure energy = over_amplitude(curve.amplitude, curve.dissipation, log, kLabel);
  Figure secant = over_amplitude(curve.amplitude, curve.secant_stiffness, log, kLabel);
  Figure loss = over_amplitude(curve.amplitude, curve.loss_factor, log, kLabel);
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

Figure path_figure(const std::vector<double>& displacement, const std::vector<double>& force) {
  Figure figure = panel_of(displacement, force);
  show_x(figure, "joint displacement", "m");
  show_y(figure, "joint force", "N");
  return figure;
}

}  // namespace microslip
