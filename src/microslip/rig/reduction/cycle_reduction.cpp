// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/cycle_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "microslip/rig/reduction/loop_stiffness.hpp"
#include "microslip/signal/harmonic/cycle_energy.hpp"
#include "microslip/signal/harmonic/turning_points.hpp"

namespace microslip {
namespace {

/// An accelerometer this close to the exciter is at it, as a share of the length.
constexpr double kSamePlace = 1e-3;

bool is_at_exciter(const Rig& rig, const RigSensor& sensor) {
  if (!rig.beam()) return sensor.shape == rig.modes()->excitation;
  return std::abs(sensor.position - rig.excitation.position) <= kSamePlace * rig.beam()->length;
}

}  // namespace

SignalLayout signal_layout(const Rig& rig, bool use_vibrometer) {
  SignalLayout layout;
  layout.accelerometers = rig.accelerometers.size();
  const auto found = std::ranges::find_if(
      rig.accelerometers, [&](const RigSensor& sensor) { return is_at_exciter(rig, sensor); });
  if (found != rig.accelerometers.end()) {
    layout.at_exciter = static_cast<std::size_t>(found - rig.accelerometers.begin());
  }
  if (use_vibrometer && rig.vibrometer) layout.vibrometer = rig.vibrometer->measures;
  return layout;
}

double damping_ratio_of(const CycleResult& cycle, double resonance_frequency) {
  double squares = 0.0;
  for (const FourierSeries& modal : cycle.motion.modal) squares += std::norm(modal.c(1));
  const double omega = 2.0 * std::numbers::pi * resonance_frequency;
  return cycle.input_energy / (2.0 * std::numbers::pi * omega * omega * squares);
}

CycleReduction::CycleReduction(const StickState& state, SignalLayout layout, double omega,
                               std::size_t harmonics)
    : state_(state), layout_(layout), observer_(state, omega, harmonics) {}

FourierSeries CycleReduction::exciter_acceleration(std::span<const FourierSeries> series,
                                                   const ModalMotion& motion) const {
  if (layout_.at_exciter) return series[1 + *layout_.at_exciter];
  FourierSeries sum;
  sum.omega = motion.rotation.omega;
  sum.harmonic.assign(motion.rotation.order(), 0.0);
  for (std::size_t i = 0; i < state_.modes(); ++i) {
    for (std::size_t n = 1; n <= sum.order(); ++n) {
      const double omega = static_cast<double>(n) * sum.omega;
      sum.harmonic[n - 1] -= omega * omega * state_.excitation[i] * motion.modal[i].c(n);
    }
  }
  return sum;
}

FourierSeries CycleReduction::displacement(std::span<const FourierSeries> series,
                                           const ModalMotion& motion) const {
  if (!layout_.vibrometer) return motion.kinematic;
  FourierSeries measured = series.back();
  if (layout_.vibrometer == RigVibrometer::Measures::kJoint) return measured;
  for (std::size_t n = 1; n <= measured.order(); ++n) {
    measured.harmonic[n - 1] += motion.rotation.c(n);
  }
  return measured;
}

CycleResult CycleReduction::reduce(std::span<const FourierSeries> series) const {
  CycleResult result;
  result.motion = observer_.observe(series[0], series.subspan(1, layout_.accelerometers));
  result.displacement = displacement(series, result.motion);
  result.exciter_acceleration = exciter_acceleration(series, result.motion);
  result.amplitude = peak_to_peak(result.displacement).amplitude();
  result.input_energy = cycle_energy(series[0], result.exciter_acceleration).energy;
  result.linear_dissipation =
      linear_dissipation(result.motion.modal, state_.loss_factor, state_.omega).energy;
  result.secant_stiffness = loop_stiffness(result.motion.joint_force, result.displacement);
  return result;
}

}  // namespace microslip
