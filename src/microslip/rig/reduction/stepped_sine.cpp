// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/stepped_sine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "microslip/base/error.hpp"
#include "microslip/rig/reduction/cycle_reduction.hpp"
#include "microslip/rig/reduction/sweep_resonance.hpp"

namespace microslip {
namespace {

FourierSeries harmonic(double omega, std::complex<double> first) {
  FourierSeries series;
  series.omega = omega;
  series.harmonic = {first};
  return series;
}

[[noreturn]] void throw_no_resonance(const SteppedSine& sweep) {
  std::vector<double> lags;
  for (const double phase : sweep.phase) {
    lags.push_back(std::abs(std::remainder(phase, 2.0 * std::numbers::pi)));
  }
  const auto [least, most] = std::ranges::minmax(lags);
  throw InputError(sweep.source + ": phase", fmt::format("{:.3g} to {:.3g} rad", least, most),
                   "must pass a quarter turn, 1.571 rad, at the resonance",
                   "Sweep over the resonance. Is it the phase of the acceleration, in rad?");
}

}  // namespace

ReducedLevel reduce_stepped_sine(const Reducer& reducer, const SteppedSine& sweep) {
  const std::optional<SweepResonance> found = resonance_of(sweep);
  const SignalLayout layout = signal_layout(reducer.rig(), false);
  if (layout.accelerometers != 1 || !layout.at_exciter) {
    throw InputError("accelerometer", fmt::format("{} accelerometers", layout.accelerometers),
                     "must be 1, at the exciter, for a stepped-sine table",
                     "The table has one acceleration.");
  }
  if (!found) throw_no_resonance(sweep);

  const double omega = 2.0 * std::numbers::pi * found->frequency;
  const std::array<FourierSeries, 2> series{harmonic(omega, found->force),
                                            harmonic(omega, {0.0, found->acceleration})};
  const CycleResult cycle = CycleReduction(reducer.state(), layout, omega, 1).reduce(series);
  ReducedLevel level;
  level.source = sweep.source;
  level.frequency = found->frequency;
  level.resonance_frequency = found->frequency;
  level.force_amplitude = found->force;
  level.response_amplitude = found->acceleration;
  level.amplitude.value = cycle.amplitude;
  level.input_energy.value = cycle.input_energy;
  level.linear_dissipation = cycle.linear_dissipation;
  level.dissipation.value = cycle.dissipation();
  level.damping_ratio = damping_ratio_of(cycle, found->frequency);
  level.misfit = cycle.motion.misfit.front();
  if (reducer.state().stiffness > 0.0) {
    level.secant_stiffness = Measured{cycle.secant_stiffness, 0.0};
  }
  level.flags = warnings_of(*found);
  return level;
}

}  // namespace microslip
