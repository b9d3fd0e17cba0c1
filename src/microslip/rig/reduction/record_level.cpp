// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/record_level.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/rig/reduction/record_flags.hpp"
#include "microslip/rig/reduction/reduction_flags.hpp"
#include "microslip/signal/harmonic/cycle_energy.hpp"
#include "microslip/signal/harmonic/signal_quality.hpp"

namespace microslip {
namespace {

/// Error of k_eq over the share of the shortening in the amplitude, by the mean tension that goes
/// with it and that no sensor measures: 0.045 in the reference rig at its highest level, less
/// below.
constexpr double kShorteningInStiffness = 0.05;

/// Standard deviation of a mean by the scatter over the cycles; where they are too few for that,
/// what the noise of the whole record makes of it.
template <typename Quantity>
double std_of(const std::vector<CycleResult>& cycles, Quantity quantity, double otherwise) {
  std::vector<double> values;
  for (const CycleResult& cycle : cycles) values.push_back(quantity(cycle));
  if (values.empty()) return otherwise;
  const double error = scatter(values).standard_error;
  return std::isfinite(error) ? error : otherwise;
}

/// Noise of u: that of the vibrometer, or of the accelerometer with the largest motion of the
/// joint, integrated.
std::vector<double> displacement_std(const RecordAnalysis& record) {
  const FourierFit& fit = record.fit;
  const SignalLayout& layout = record.layout;
  if (layout.vibrometer) return fit.harmonic_std.back();
  std::size_t most = 1;
  for (std::size_t j = 1; j <= layout.accelerometers; ++j) {
    if (std::abs(fit.series[j].c(1)) > std::abs(fit.series[most].c(1))) most = j;
  }
  const double gain = std::abs(record.whole.displacement.c(1)) / std::abs(fit.series[most].c(1));
  std::vector<double> std = fit.harmonic_std[most];
  for (std::size_t n = 1; n <= std.size(); ++n) {
    std[n - 1] *= gain / static_cast<double>(n * n);
  }
  return std;
}

/// The accelerometer at the exciter, as a signal of the record; the first one where none is.
std::size_t exciter_signal(const RecordAnalysis& record) {
  return 1 + record.layout.at_exciter.value_or(0);
}

void set_energies(ReducedLevel& level, const RecordAnalysis& record) {
  const std::size_t exciter = exciter_signal(record);
  const CycleResult& whole = record.whole;
  const double noise = cycle_energy(record.fit.series[0], whole.exciter_acceleration,
                                    record.fit.harmonic_std[0], record.fit.harmonic_std[exciter])
                           .std_error;
  level.linear_dissipation = whole.linear_dissipation;
  level.input_energy.value = whole.input_energy;
  level.input_energy.std = std_of(
      record.each, [](const CycleResult& c) { return c.input_energy; }, noise);
  level.dissipation.value = whole.dissipation();
  level.dissipation.std = std_of(
      record.each, [](const CycleResult& c) { return c.dissipation(); }, noise);
  if (!record.layout.at_exciter) return;
  const SampledEnergy sum = cycle_energy_from_samples(
      record.recording.axis, record.signals.values[0], record.signals.values[exciter],
      record.fit.series[0], record.fit.series[exciter], VelocityFrom::kSamples);
  level.input_energy_by_sum = Measured{sum.energy, sum.std_error};
}

/// A, and k_eq where k is known; its standard deviation includes the possible effect of the
/// unmeasured mean tension.
void set_joint(ReducedLevel& level, const RecordAnalysis& record, bool stiffness_is_known) {
  const CycleResult& whole = record.whole;
  const std::vector<double> noise = displacement_std(record);
  level.amplitude.value = whole.amplitude;
  level.amplitude.std = std_of(
      record.each, [](const CycleResult& c) { return c.amplitude; }, noise.front());
  level.reversals = reversals(whole.displacement, noise).count();
  if (!stiffness_is_known) return;
  const double k = whole.secant_stiffness;
  const double relative = noise.front() / whole.amplitude;
  const double scatter = std_of(
      record.each, [](const CycleResult& c) { return c.secant_stiffness; }, relative * std::abs(k));
  const double tension =
      kShorteningInStiffness * k * whole.motion.mean_shortening / whole.amplitude;
  level.secant_stiffness = Measured{k, std::hypot(scatter, tension)};
}

}  // namespace

ReducedLevel reduced_level(const RecordAnalysis& record, const Rig& rig, const StickState& state,
                           const ReductionOptions& options) {
  ReducedLevel level;
  level.source = record.recording.source;
  level.frequency = record.fit.frequency();
  level.resonance_frequency = natural_frequency(state, record.whole.motion.softening);
  level.force_amplitude = std::abs(record.fit.series[0].c(1));
  level.response_amplitude = std::abs(record.whole.exciter_acceleration.c(1));
  level.force_distortion = force_distortion_of(record.fit.series[0], record.fit.harmonic_std[0]);
  level.misfit = *std::ranges::max_element(record.whole.motion.misfit);
  level.cycles = record.fit.cycles;
  set_joint(level, record, state.stiffness > 0.0);
  set_energies(level, record);
  level.damping_ratio = damping_ratio_of(record.whole, level.resonance_frequency);
  add_flags(level, record, rig, state, options);
  return level;
}

}  // namespace microslip
