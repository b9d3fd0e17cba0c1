// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/reduction_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string_view>

#include "microslip/base/percent.hpp"
#include "microslip/base/plausibility.hpp"
#include "microslip/rig/reduction/record_flags.hpp"

namespace microslip {
namespace {

constexpr double kSignificant = 3.0;  // standard deviations
/// Largest ratio of the drive to the rig's first mode: beyond it the rig is not the measured one.
constexpr double kFarFromMode = 1.5;
constexpr double kMostAboveStuck = 1.1;
/// Relative difference of an energy by two summations that is more than rounding.
constexpr double kSignificantEnergy = 1e-6;

void add_flag(ReducedLevel& level, std::string_view code, std::string_view text) {
  add_flag_once(level.flags, code, text);
}

// ---- Of the level. ----

void flag_reversals(ReducedLevel& level) {
  if (level.reversals <= 2) return;
  add_flag(level, kInnerReversals,
           fmt::format("{} reversals of the joint displacement per cycle: the density follows from "
                       "D where there are 2.",
                       level.reversals));
}

void flag_dissipation(ReducedLevel& level, double stiffness) {
  const Measured& d = level.dissipation;
  const double bound = stiffness * level.amplitude.value * level.amplitude.value;
  if (d.value < 0.0) {
    add_flag(
        level, kNegativeDissipation,
        fmt::format("D = {:.3g} J: the input of {:.3g} J is below the linear loss of {:.3g} J. "
                    "Check sign and unit of the force, and the loss factors.",
                    d.value, level.input_energy.value, level.linear_dissipation));
  } else if (stiffness > 0.0 && d.value > bound) {
    add_flag(
        level, "dissipation_above_bound",
        fmt::format("D = {:.3g} J is above k A^2 = {:.3g} J, the most that a joint of stiffness k "
                    "can lose. Check the units of force, acceleration and displacement.",
                    d.value, bound));
  } else if (d.value < kSignificant * d.std) {
    add_flag(level, "dissipation_in_noise",
             fmt::format("D = {:.3g} J has a standard deviation of {:.3g} J.", d.value, d.std));
  }
}

void flag_values(ReducedLevel& level) {
  auto flag = implausible_value("The joint", kLength, level.amplitude.value);
  if (!flag) flag = implausible_value("The joint", kEnergy, level.dissipation.value);
  if (flag) add_flag(level, flag->code, flag->text);
}

void flag_secant_stiffness(ReducedLevel& level, double stiffness) {
  if (!level.secant_stiffness) return;
  const double k_eq = level.secant_stiffness->value;
  if (!(k_eq > 0.0)) {
    add_flag(
        level, "secant_not_positive",
        fmt::format("k_eq = {:.3g} N/m is left out. Check the sign of the displacement and the "
                    "rig's first frequency.",
                    k_eq));
    level.secant_stiffness.reset();
  } else if (k_eq > kMostAboveStuck * stiffness) {
    add_flag(level, "secant_above_stuck",
             fmt::format("k_eq = {:.3g} N/m is above k = {:.3g} N/m of the stuck joint. Check the "
                         "rig's first frequency.",
                         k_eq, stiffness));
  }
}

void flag_energies(ReducedLevel& level) {
  if (!level.input_energy_by_sum) return;
  const Measured& sum = *level.input_energy_by_sum;
  const double difference = std::abs(level.input_energy.value - sum.value);
  const double error = std::hypot(level.input_energy.std, sum.std);
  if (!(difference > kSignificant * error) || difference < kSignificantEnergy * std::abs(sum.value))
    return;
  add_flag(
      level, "energies_differ",
      fmt::format("The input energy is {:.4g} J by the Fourier coefficients and {:.4g} J by the "
                  "sum over the samples.",
                  level.input_energy.value, sum.value));
}

// ---- Of the rig. ----

void flag_frequency(ReducedLevel& level, const StickState& state) {
  const double first = natural_frequency(state, 0.0);
  if (level.frequency <= kFarFromMode * first && first <= kFarFromMode * level.frequency) return;
  add_flag(
      level, "far_from_first_mode",
      fmt::format("{:.5g} Hz is far from the rig's first mode, {:.5g} Hz. Check the beam and the "
                  "units of the rig.",
                  level.frequency, first));
}

void flag_misfit(ReducedLevel& level, const Rig& rig, const std::vector<double>& misfit,
                 double most) {
  if (level.misfit <= most) return;
  const auto worst = static_cast<std::size_t>(std::ranges::max_element(misfit) - misfit.begin());
  add_flag(
      level, "model_misfit",
      fmt::format("The rig's modes leave {} of channel '{}' unexplained, more than {:.2g} "
                  "%. Check position, sign and unit of the accelerometers, and the beam.",
                  percent_text(level.misfit), rig.accelerometers[worst].channel, 100.0 * most));
}

/// Its sign and phase count as well.
void flag_vibrometer(ReducedLevel& level, const Rig& rig, const CycleResult& cycle, double most) {
  const std::complex<double> ratio = cycle.displacement.c(1) / cycle.motion.kinematic.c(1);
  if (std::abs(ratio - 1.0) <= most) return;
  add_flag(
      level, "vibrometer_mismatch",
      fmt::format("Channel '{}' gives {:.3g} times the joint displacement that follows from the "
                  "accelerometers, {:.2g} rad out of phase. Check its sign, its unit, and what it "
                  "measures.",
                  rig.vibrometer->channel, std::abs(ratio), std::abs(std::arg(ratio))));
}

}  // namespace

void add_flags(ReducedLevel& level, const RecordAnalysis& record, const Rig& rig,
               const StickState& state, const ReductionOptions& options) {
  flag_reversals(level);
  flag_frequency(level, state);
  flag_misfit(level, rig, record.whole.motion.misfit, options.most_misfit);
  if (record.layout.vibrometer) {
    flag_vibrometer(level, rig, record.whole, options.most_mismatch);
  }
  flag_dissipation(level, state.stiffness);
  flag_values(level);
  flag_secant_stiffness(level, state.stiffness);
  flag_energies(level);
  flag_force_distortion(level.flags, level.force_distortion, options.most_distortion);
  flag_record(level.flags, record, options.most_phase);
}

}  // namespace microslip
