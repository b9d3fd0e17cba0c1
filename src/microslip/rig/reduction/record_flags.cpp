// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/record_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <string>

#include "microslip/base/percent.hpp"
#include "microslip/signal/harmonic/signal_quality.hpp"

namespace microslip {
namespace {

constexpr double kFewCycles = 10.0;
/// The largest of 1e9 residuals of normal noise is at 6 of its standard deviations.
constexpr double kSpike = 8.0;
/// A noisy cycle is not one out of step.
constexpr double kSignificantPhase = 5.0;  // standard deviations

/// A jump of the phase, lost samples, a drive whose frequency drifts: some cycle is out of phase
/// with the whole record.
void flag_phase(std::vector<Warning>& flags, const FittedRecord& record, std::size_t signal,
                double most) {
  const std::complex<double> whole = record.fit.series[signal].c(1);
  double largest = 0.0;
  double when = 0.0;
  for (std::size_t b = 0; b < record.cycles.block.size(); ++b) {
    const double phase = std::abs(std::arg(record.cycles.block[b][signal].c(1) / whole));
    if (phase <= largest) continue;
    largest = phase;
    when = record.cycles.middle[b];
  }
  const double cycles = static_cast<double>(record.cycles.block.size());
  const double noise = record.fit.residual_rms[signal] / std::abs(whole) *
                       std::sqrt(2.0 * cycles / static_cast<double>(record.fit.points));
  if (largest <= std::max(most, kSignificantPhase * noise)) return;
  add_flag_once(
      flags, "phase_unsteady",
      fmt::format("No steady state: at {:.4g} s channel '{}' is {:.2g} rad out of phase with the "
                  "whole record. Are samples missing, or does the drive's frequency drift?",
                  when, record.signals.names[signal], largest));
}

void flag_spike(std::vector<Warning>& flags, const FittedRecord& record, std::size_t signal) {
  const double ratio = record.fit.residual_peak[signal] / record.fit.residual_rms[signal];
  // Residuals that are rounding are not noise.
  const bool rounding = record.fit.residual_peak[signal] < 1e-6 * rms(record.fit.series[signal]);
  if (!(ratio > kSpike) || rounding) return;
  add_flag_once(
      flags, "spike",
      fmt::format("At {:.6g} s channel '{}' is off by {:.3g} times the rms of its residuals.",
                  record.recording.axis.at(record.fit.peak_point[signal]),
                  record.signals.names[signal], ratio));
}

}  // namespace

void add_flag_once(std::vector<Warning>& flags, std::string_view code, std::string_view text) {
  if (std::ranges::find(flags, code, &Warning::code) != flags.end()) return;
  flags.push_back({std::string(code), std::string(text)});
}

double force_distortion_of(const FourierSeries& force, std::span<const double> harmonic_std) {
  double square = 0.0;
  for (std::size_t n = 2; n <= force.order(); ++n) {
    square += std::norm(force.c(n)) - 2.0 * harmonic_std[n - 1] * harmonic_std[n - 1];
  }
  return std::sqrt(std::max(square, 0.0)) / std::abs(force.c(1));
}

void flag_force_distortion(std::vector<Warning>& flags, double distortion, double most) {
  if (distortion <= most) return;
  add_flag_once(flags, "force_distortion",
                fmt::format("Harmonics of the force are {} of the fundamental, above {:.2g} %.",
                            percent_text(distortion), 100.0 * most));
}

void flag_record(std::vector<Warning>& flags, const FittedRecord& record, double most_phase) {
  const RecordSignals& signals = record.signals;
  for (std::size_t j = 0; j < signals.names.size(); ++j) {
    flag_phase(flags, record, j, most_phase);
    flag_spike(flags, record, j);
    const SignalQuality quality = signal_quality(record.recording.axis, signals.values, record.fit,
                                                 record.cycles, j, signals.names[j]);
    for (const Warning& warning : quality.warnings)
      add_flag_once(flags, warning.code, warning.text);
  }
  for (const Warning& warning : record.fit.warnings)
    add_flag_once(flags, warning.code, warning.text);
  if (!record.recording.axis.even()) {
    add_flag_once(flags, "uneven_sampling", "The samples are not evenly spaced.");
  }
  if (record.fit.cycles >= kFewCycles) return;
  add_flag_once(flags, "few_cycles",
                fmt::format("{:.1f} cycles: too few for a reliable scatter.", record.fit.cycles));
}

}  // namespace microslip
