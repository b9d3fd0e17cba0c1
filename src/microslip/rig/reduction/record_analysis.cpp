// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/record_analysis.hpp"

#include <fmt/format.h>

#include <cmath>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

RecordSignals signals_of(const Recording& recording, const Rig& rig, const SignalLayout& layout) {
  RecordSignals signals;
  signals.add(recording, rig.excitation.channel, kForce);
  for (const RigSensor& sensor : rig.accelerometers) {
    signals.add(recording, sensor.channel, kAcceleration);
  }
  if (layout.vibrometer) signals.add(recording, rig.vibrometer->channel, kLength);
  return signals;
}

}  // namespace

RecordAnalysis analyse_record(const Recording& recording, const Rig& rig, const StickState& state,
                              const FourierFitOptions& options, bool use_vibrometer) {
  check_recording(recording);
  const SignalLayout layout = signal_layout(rig, use_vibrometer);
  RecordAnalysis result{
      fit_record(recording, signals_of(recording, rig, layout), options), layout, {}, {}};
  const CycleReduction reduction(state, layout, result.fit.omega, result.fit.order());
  result.whole = reduction.reduce(result.fit.series);
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
