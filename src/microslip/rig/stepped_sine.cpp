// SPDX-License-Identifier: MIT
#include "microslip/rig/stepped_sine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/rig/cycle_reduction.hpp"

namespace microslip {
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

void check_column(const SteppedSine& sweep, std::string_view name,
                  const std::vector<double>& values, bool positive) {
  if (values.size() != sweep.frequency.size()) {
    throw InputError(fmt::format("{}: {}", sweep.source, name),
                     fmt::format("{} values", values.size()),
                     fmt::format("must have {}, as the frequency", sweep.frequency.size()));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && (values[i] > 0.0 || !positive)) continue;
    throw InputError(fmt::format("{}: {} of step {}", sweep.source, name, i + 1), values[i],
                     positive ? "must be above 0 and finite" : "must be finite");
  }
}

/// One step: those of the sweep, or one between two of them.
struct Step {
  double frequency;
  double force;
  double acceleration;
  double phase;  // without sign
};

/// The steps by rising frequency. The phase is taken without its sign: its sign is one of
/// convention, and a passive structure takes energy.
std::vector<Step> sorted_steps(const SteppedSine& sweep) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < sweep.frequency.size(); ++i) {
    steps.push_back({sweep.frequency[i], sweep.force[i], sweep.acceleration[i],
                     std::abs(std::remainder(sweep.phase[i], 2.0 * std::numbers::pi))});
  }
  std::ranges::stable_sort(steps, {}, &Step::frequency);
  return steps;
}

Step between(const Step& a, const Step& b) {
  const double share = (kQuarterTurn - a.phase) / (b.phase - a.phase);
  const auto geometric = [&](double x, double y) { return x * std::pow(y / x, share); };
  return {std::lerp(a.frequency, b.frequency, share), geometric(a.force, b.force),
          geometric(a.acceleration, b.acceleration), kQuarterTurn};
}

std::vector<Step> resonances(const std::vector<Step>& steps) {
  std::vector<Step> found;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double before = steps[i - 1].phase - kQuarterTurn;
    const double after = steps[i].phase - kQuarterTurn;
    if ((before < 0.0) != (after < 0.0)) found.push_back(between(steps[i - 1], steps[i]));
  }
  return found;
}

FourierSeries harmonic(double omega, std::complex<double> first) {
  FourierSeries series;
  series.omega = omega;
  series.harmonic = {first};
  return series;
}

[[noreturn]] void throw_no_resonance(const SteppedSine& sweep) {
  const std::vector<Step> steps = sorted_steps(sweep);
  const auto [least, most] = std::ranges::minmax(steps, {}, &Step::phase);
  throw InputError(sweep.source + ": phase",
                   fmt::format("{:.3g} to {:.3g} rad", least.phase, most.phase),
                   "must pass a quarter turn, 1.571 rad, at the resonance",
                   "Sweep over the resonance. Is it the phase of the acceleration, in rad?");
}

}  // namespace

void check_stepped_sine(const SteppedSine& sweep) {
  if (sweep.frequency.size() < 2) {
    throw InputError(sweep.source, fmt::format("{} steps", sweep.frequency.size()),
                     "must have 2 at least");
  }
  check_column(sweep, "frequency", sweep.frequency, true);
  check_column(sweep, "force", sweep.force, true);
  check_column(sweep, "acceleration", sweep.acceleration, true);
  check_column(sweep, "phase", sweep.phase, false);
}

std::optional<SweepResonance> resonance_of(const SteppedSine& sweep) {
  check_stepped_sine(sweep);
  const std::vector<Step> found = resonances(sorted_steps(sweep));
  if (found.empty()) return std::nullopt;
  const Step& step = *std::ranges::max_element(found, {}, &Step::acceleration);
  return SweepResonance{step.frequency, step.force, step.acceleration, found.size()};
}

ReducedLevel reduce_stepped_sine(const Reducer& reducer, const SteppedSine& sweep) {
  const std::optional<SweepResonance> found = resonance_of(sweep);
  const SignalLayout layout = signal_layout(reducer.rig(), false);
  if (layout.accelerometers != 1 || !layout.at_exciter) {
    throw InputError("accelerometer", fmt::format("{} of them", layout.accelerometers),
                     "must be one, at the exciter, for a stepped-sine table",
                     "The table has one acceleration.");
  }
  if (!found) throw_no_resonance(sweep);

  const double omega = 2.0 * std::numbers::pi * found->frequency;
  const std::array<FourierSeries, 2> series{
      harmonic(omega, found->force),
      harmonic(omega, std::polar(found->acceleration, kQuarterTurn))};
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
  level.misfit = cycle.motion.misfit.front();
  if (reducer.state().stiffness > 0.0) {
    level.secant_stiffness = Measured{cycle.secant_stiffness, 0.0};
  }
  if (found->passages > 1) {
    level.flags.push_back(
        {"several_resonances",
         fmt::format("The phase passes a quarter turn {} times.", found->passages)});
  }
  return level;
}

}  // namespace microslip
