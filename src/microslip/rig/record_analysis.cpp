// SPDX-License-Identifier: MIT
#include "microslip/rig/record_analysis.hpp"

#include <fmt/format.h>

#include <cmath>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

RecordSignals signals_of(const Recording& recording, const Rig& rig, const SignalLayout& layout) {
  RecordSignals signals;
  const auto add = [&](const std::string& name, const Dimension& dimension) {
    signals.values.push_back(recording.signal(name, dimension));
    signals.names.push_back(name);
  };
  add(rig.excitation.channel, kForce);
  for (const RigSensor& sensor : rig.accelerometers) add(sensor.channel, kAcceleration);
  if (layout.vibrometer) add(rig.vibrometer->channel, kLength);
  return signals;
}

/// The fit's own complaints know no file.
FourierFit fit_named(const Recording& recording, const RecordSignals& signals,
                     const FourierFitOptions& options) {
  try {
    return fit_fourier(recording.axis, signals.values, options);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", recording.source, error.name()));
  }
}

FourierFit fit_of(const Recording& recording, const RecordSignals& signals,
                  const FourierFitOptions& options) {
  FourierFit fit = fit_named(recording, signals, options);
  if (!fit.summary.converged()) {
    throw InputError(recording.source, "no steady vibration",
                     fmt::format("must hold periodic signals: {}", fit.summary.reason),
                     options.frequency_guess
                         ? "Is the frequency that of the record? Without one it is sought."
                         : "Cut the record to its steady part, or state the frequency.");
  }
  for (std::size_t j = 0; j < signals.names.size(); ++j) {
    if (std::abs(fit.series[j].c(1)) > 0.0) continue;
    throw InputError(fmt::format("{}: channel '{}'", recording.source, signals.names[j]),
                     "constant", "must vibrate", "Is the sensor connected?");
  }
  return fit;
}

}  // namespace

RecordAnalysis analyse_record(const Recording& recording, const Rig& rig, const StickState& state,
                              const FourierFitOptions& options, bool use_vibrometer) {
  check_recording(recording);
  RecordAnalysis result{.recording = recording,
                        .layout = signal_layout(rig, use_vibrometer),
                        .signals = {},
                        .fit = {},
                        .cycles = {},
                        .whole = {},
                        .each = {}};
  result.signals = signals_of(recording, rig, result.layout);
  result.fit = fit_of(recording, result.signals, options);
  const FourierFit& fit = result.fit;
  result.cycles = cycle_series(recording.axis, result.signals.values, fit,
                               {.order = static_cast<int>(fit.order())});
  const CycleReduction reduction(state, result.layout, fit.omega, fit.order());
  result.whole = reduction.reduce(fit.series);
  for (const auto& cycle : result.cycles.block) result.each.push_back(reduction.reduce(cycle));
  if (std::isfinite(result.whole.amplitude) && std::isfinite(result.whole.dissipation())) {
    return result;
  }
  throw InputError(
      recording.source + ": joint displacement and dissipation",
      fmt::format("{:g} m and {:g} J", result.whole.amplitude, result.whole.dissipation()),
      "must be finite", "Check the shapes and frequencies of the rig.");
}

}  // namespace microslip
