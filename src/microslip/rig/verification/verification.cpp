// SPDX-License-Identifier: MIT
#include "microslip/rig/verification/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/joint/covered_range.hpp"
#include "microslip/rig/reduction/channel_harmonics.hpp"
#include "microslip/rig/reduction/record_analysis.hpp"
#include "microslip/rig/reduction/record_level.hpp"
#include "microslip/rig/setup/rig_structure.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;

/// Noise reaches it in one harmonic of 3000; a resonance of a higher mode would make much of it.
constexpr double kSignificantHarmonic = 4.0;  // standard errors
/// Largest offset from the frequency of the record, relative.
constexpr double kFarthest = 0.2;

/// s_n of the excitation: the harmonics of the force over the first, with the zero of time where
/// that is largest.
std::vector<Complex> force_shape(const RecordAnalysis& record, bool sine) {
  std::vector<Complex> shape{1.0};
  if (sine) return shape;
  const FourierSeries& force = record.fit.series[0];
  const double size = std::abs(force.c(1));
  const double phase = std::arg(force.c(1));
  for (std::size_t n = 2; n <= force.order(); ++n) {
    const bool significant =
        std::abs(force.c(n)) > kSignificantHarmonic * record.fit.harmonic_std[0][n - 1];
    shape.push_back(
        significant ? force.c(n) / size * std::polar(1.0, -static_cast<double>(n) * phase) : 0.0);
  }
  return shape;
}

/// Phase lag of the displacement at the exciter behind the force, rad.
double recorded_lag(const RecordAnalysis& record) {
  return std::arg(-record.fit.series[0].c(1) * std::conj(record.whole.exciter_acceleration.c(1)));
}

/// Which mode of the stuck structure vibrates at ω.
std::size_t nearest_mode(const JointedStructure& structure, double omega) {
  const std::vector<double> all = structure.stuck_frequencies();
  const auto nearest = std::ranges::min_element(
      all, {}, [&](double frequency) { return std::abs(frequency - omega); });
  return static_cast<std::size_t>(nearest - all.begin());
}

/// A solution that converged, within 20 % of the frequency of the record.
bool is_near(const VibrationResult& found, const RecordedSetting& setting) {
  const double difference = found.vibration.angular_frequency - setting.angular_frequency;
  return found.summary.converged() && std::abs(difference) <= kFarthest * setting.angular_frequency;
}

/// With the recorded phase and another quantity of the record.
std::optional<SteadyVibration> at_phase(const HarmonicBalance& balance,
                                        const RecordedSetting& setting, const Target& other,
                                        const SteadyVibration& start) {
  if (!(setting.phase_lag > 0.0 && setting.phase_lag < std::numbers::pi)) return std::nullopt;
  const Target phase{Quantity::kPhaseLag, setting.phase_lag};
  VibrationResult found = balance.solve(phase, other, start);
  if (is_near(found, setting)) return std::move(found.vibration);
  found = balance.solve(phase, other, nearest_mode(balance.structure(), setting.angular_frequency));
  if (is_near(found, setting)) return std::move(found.vibration);
  return std::nullopt;
}

RecordedSetting setting_of(const RecordAnalysis& record, const ReducedLevel& level, bool sine) {
  return {.angular_frequency = record.fit.omega,
          .response = level.response_amplitude,
          .force = level.force_amplitude,
          .phase_lag = recorded_lag(record),
          .force_shape = force_shape(record, sine),
          .harmonics = record.fit.order()};
}

PredictedLevel predicted_level(const SteadyVibration& vibration) {
  const JointCycle& joint = vibration.joints.front();
  return {.force_amplitude = vibration.force_amplitude,
          .amplitude = joint.amplitude,
          .input_energy = vibration.input_energy,
          .linear_dissipation = vibration.linear_dissipation,
          .dissipation = joint.dissipation};
}

/// The predicted harmonics on mean, trend and time axis of the recorded series. What is not finite,
/// because the balance was lost, predicts nothing.
FourierSeries predicted_series(const FourierSeries& recorded, const Harmonics& harmonics,
                               double turn) {
  FourierSeries series = recorded;
  series.harmonic.assign(harmonics.size() - 1, 0.0);
  for (std::size_t n = 1; n < harmonics.size(); ++n) {
    const Complex turned = harmonics[n] * std::polar(1.0, static_cast<double>(n) * turn);
    if (std::isfinite(std::abs(turned))) series.harmonic[n - 1] = turned;
  }
  return series;
}

double rms_difference(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

ChannelComparison compare(const RecordAnalysis& record, std::size_t signal,
                          const Harmonics& harmonics, double turn) {
  const Axis& axis = record.recording.axis;
  const std::span<const double> samples = record.signals.values[signal];
  ChannelComparison channel;
  channel.name = record.signals.names[signal];
  channel.dimension = *record.recording.channel(channel.name).dimension;
  channel.recorded = record.fit.series[signal];
  channel.predicted = predicted_series(channel.recorded, harmonics, turn);
  channel.recorded_std = record.fit.harmonic_std[signal];
  FourierSeries slow = channel.recorded;
  slow.harmonic.clear();
  const double size = rms_difference(samples, values(slow, axis, samples.size()));
  channel.nrmse = rms_difference(samples, values(channel.predicted, axis, samples.size())) / size;
  channel.noise_share = record.fit.residual_rms[signal] / size;
  return channel;
}

/// From the first of the points where the drive-point acceleration is largest, as to its first
/// harmonic.
void add_histories(Verification& result, const RecordAnalysis& record, double cycles) {
  const Axis& axis = record.recording.axis;
  const double period = record.whole.exciter_acceleration.period();
  const double turns = axis.at(0) / period + result.phase / (2.0 * std::numbers::pi);
  const double from = axis.at(0) + (std::ceil(turns) - turns) * period;
  for (std::size_t i = 0; i < record.recording.size(); ++i) {
    const double t = axis.at(i);
    if (t < from || t > from + cycles * period) continue;
    result.history.push_back(t);
    for (std::size_t j = 0; j < result.channels.size(); ++j) {
      ChannelComparison& channel = result.channels[j];
      channel.recorded_history.push_back(record.signals.values[j][i]);
      channel.predicted_history.push_back(channel.predicted.value(t));
    }
  }
}

/// η f of the record, Hz: its loss per cycle over 2π times its largest kinetic energy.
double half_power_width(const RecordAnalysis& record) {
  double square = 0.0;
  for (const FourierSeries& modal : record.whole.motion.modal) square += std::norm(modal.c(1));
  const double energy = 0.5 * record.fit.omega * record.fit.omega * square;
  return record.whole.input_energy / (2.0 * std::numbers::pi * energy) * record.fit.frequency();
}

/// Warns of the effects of a joint of wrong stiffness or wrong energies on the prediction.
void add_misfits(const RecordAnalysis& record, Verification& result) {
  constexpr double kMostOffset = 0.1;  // of the half-power width
  constexpr double kMostForceError = 0.02;
  constexpr double kSignificantError = 3.0;  // times the noise
  const double width = half_power_width(record);
  const std::optional<double> offset = result.predicted.frequency_offset;
  if (offset && std::abs(*offset) > kMostOffset * width) {
    result.warnings.push_back(
        {"resonance_off",
         fmt::format(
             "the resonance of the model lies {:.0f} mHz {} that of the record, {:.0f} % of "
             "the half-power width of {:.0f} mHz, so that force and phase near it are wrong. "
             "Check k of the joint and the rig's first frequency.",
             1e3 * std::abs(*offset), *offset > 0.0 ? "above" : "below",
             100.0 * std::abs(*offset) / width, 1e3 * width)});
  }
  const ChannelComparison& force = result.channels.front();
  if (force.nrmse > kMostForceError && force.nrmse > kSignificantError * force.noise_share) {
    result.warnings.push_back(
        {"force_off",
         fmt::format("the force is predicted wrong by {} (NRMSE), {:.3g} times its noise. Check "
                     "the sign of the force, the offset of the resonance and the energies.",
                     percent_text(force.nrmse), force.nrmse / force.noise_share)});
  }
}

}  // namespace

const ChannelComparison& Verification::worst() const {
  return *std::ranges::max_element(channels, {}, &ChannelComparison::nrmse);
}

Verifier::Verifier(Rig rig, Joint joint, VerificationOptions options)
    : reducer_(std::move(rig), options.reduction),
      joint_(std::move(joint)),
      options_(std::move(options)) {
  if (options_.covered_to && !(*options_.covered_to > 0.0)) {
    throw InputError("covered_to", *options_.covered_to, "must be above 0 N");
  }
  if (!(options_.history_cycles >= 0.0)) {
    throw InputError("history_cycles", options_.history_cycles, "must be 0 or more");
  }
  // Throws where the rig or an option makes none.
  (void)balance({.force_shape = {1.0}});
}

HarmonicBalance Verifier::balance(const RecordedSetting& setting) const {
  const Rig& rig = reducer_.rig();
  HarmonicBalanceOptions options = options_.balance;
  options.harmonics = std::max(options.harmonics, setting.harmonics);
  return {
      rig_structure(rig, reducer_.state(), joint_, setting.force_shape, options_.linear_damping),
      {rig.excitation.channel, ResponseKind::kAcceleration},
      options};
}

PredictedVibration predict_at(const HarmonicBalance& balance, const RecordedSetting& setting,
                              const SteadyVibration* start) {
  const Target frequency{Quantity::kAngularFrequency, setting.angular_frequency};
  const Target response{Quantity::kResponse, setting.response};
  VibrationResult found = start == nullptr ? balance.solve(frequency, response)
                                           : balance.solve(frequency, response, *start);
  PredictedVibration predicted{std::move(found.vibration), {}, std::move(found.summary)};
  predicted.level = predicted_level(predicted.vibration);
  if (const auto there = at_phase(balance, setting, response, predicted.vibration)) {
    predicted.level.frequency_offset =
        there->frequency() - setting.angular_frequency / (2.0 * std::numbers::pi);
  }
  return predicted;
}

std::optional<PredictedPeak> predict_peak(const HarmonicBalance& balance,
                                          const RecordedSetting& setting,
                                          const SteadyVibration& start) {
  const auto there = at_phase(balance, setting, {Quantity::kForceAmplitude, setting.force}, start);
  if (!there) return std::nullopt;
  return PredictedPeak{there->frequency(), there->response};
}

Verification Verifier::verify(const Recording& recording) const {
  const Rig& rig = reducer_.rig();
  const StickState& state = reducer_.state();
  const RecordAnalysis record = analyse_record(recording, rig, state, reducer_.options().fit,
                                               reducer_.options().use_vibrometer);
  Verification result;
  result.recorded = reduced_level(record, rig, state, reducer_.options());
  result.phase = std::arg(record.whole.exciter_acceleration.c(1));
  result.setting = setting_of(record, result.recorded, options_.sine);

  const HarmonicBalance balance = this->balance(result.setting);
  PredictedVibration found = predict_at(balance, result.setting);
  result.summary = std::move(found.summary);
  result.predicted = found.level;
  result.vibration = std::move(found.vibration);

  const JointedStructure& structure = balance.structure();
  const Complex drive_point =
      result.vibration.acceleration(structure.linear(), rig.excitation.channel)[1];
  const std::vector<Harmonics> harmonics = channel_harmonics(
      result.vibration, force_harmonics(result.vibration, structure.excitations().front()), rig,
      state, record.layout);
  for (std::size_t j = 0; j < harmonics.size(); ++j) {
    result.channels.push_back(
        compare(record, j, harmonics[j], result.phase - std::arg(drive_point)));
  }
  if (record.layout.at_exciter) result.drive_point = 1 + *record.layout.at_exciter;
  add_histories(result, record, options_.history_cycles);
  if (auto warning =
          beyond_identification(joint_, result.predicted.amplitude, options_.covered_to)) {
    result.warnings.push_back(std::move(*warning));
  }
  if (auto other = stiffness_warning(reducer_.state(), joint_)) {
    result.warnings.push_back(std::move(*other));
  }
  if (result.summary.converged()) add_misfits(record, result);
  return result;
}

}  // namespace microslip
