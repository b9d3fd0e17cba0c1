// SPDX-License-Identifier: MIT
#include "microslip/signal/ring_down.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/signal/decay_range.hpp"
#include "microslip/signal/decay_walk.hpp"
#include "microslip/signal/mode_peak.hpp"
#include "microslip/signal/tapered_transform.hpp"

namespace microslip {
namespace {

constexpr double kLines = 6.0;   // of a window's resolution 1/T between a mode and what is kept out
constexpr double kSearch = 0.1;  // about the frequency that is given
constexpr double kWidest = 0.2;  // how far a mode's frequency may move, where nothing is near
constexpr double kHighest = 0.45;  // of the sampling rate

void check_positive(std::string_view name, double value, double most) {
  if (value > 0.0 && value <= most) return;
  throw InputError(name, value, fmt::format("must be above 0 and at most {:g}", most));
}

void check_options(const RingDownOptions& options, double rate) {
  if (!(rate > 0.0 && std::isfinite(rate))) {
    throw InputError("sampling rate", rate, "must be above 0 Hz and finite");
  }
  if (options.frequency) check_positive("frequency", *options.frequency, kHighest * rate);
  if (options.band) {
    const auto [low, high] = *options.band;
    if (!(low > 0.0 && low < high && high <= 0.5 * rate)) {
      throw InputError("band", fmt::format("{:g} to {:g} Hz", low, high),
                       "must rise from above 0 to at most half of the sampling rate");
    }
    if (options.frequency && !(low < *options.frequency && *options.frequency < high)) {
      throw InputError("frequency", *options.frequency,
                       fmt::format("must be inside of the band, {:g} to {:g} Hz", low, high));
    }
  }
  if (!(options.least_periods >= 3.0 && options.least_periods <= 1000.0)) {
    throw InputError("least_periods", options.least_periods, "must be from 3 to 1000");
  }
  check_positive("largest_fall", options.largest_fall, 6.0);
  check_positive("wanted_std", options.wanted_std, 1.0);
  check_positive("largest_std", options.largest_std, 1.0);
}

void check_signal(std::span<const double> signal) {
  constexpr std::size_t kFewest = 32;
  if (signal.size() < kFewest) {
    throw InputError("number of samples", fmt::format("{}", signal.size()),
                     fmt::format("must be {} at least: too short for a decay", kFewest));
  }
  const auto bad = std::ranges::find_if_not(signal, [](double y) { return std::isfinite(y); });
  if (bad == signal.end()) return;
  throw InputError(fmt::format("sample {}", bad - signal.begin() + 1), *bad, "must be finite");
}

/// The part of the signal between the options' times; its offset is kept beside it.
struct Cut {
  std::span<const double> signal;
  double offset = 0.0;  ///< s
};

Cut cut(std::span<const double> signal, double rate, const RingDownOptions& options) {
  const double duration = static_cast<double>(signal.size()) / rate;
  const double from = options.from.value_or(0.0);
  const double to = options.to.value_or(duration);
  if (!(from < to && from < duration && to > 0.0)) {
    throw InputError("range", fmt::format("{:g} to {:g} s", from, to),
                     fmt::format("must rise and meet the record, 0 to {:g} s", duration));
  }
  const double last = static_cast<double>(signal.size());
  const double first = std::clamp(std::ceil(from * rate), 0.0, last);
  const double end = std::clamp(std::floor(to * rate), first, last);
  return {signal.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first)),
          first / rate};
}

/// The signal less its mean over the last half under cos⁴: there the oscillation is small, and the
/// taper lets next to nothing of it into the mean. An offset would pass for a large amplitude in the
/// short windows that tell where the decay begins, and its rest for one where little is left of it.
std::vector<double> without_offset(std::span<const double> signal, double rate) {
  const double duration = static_cast<double>(signal.size() - 1) / rate;
  const TaperedWindow tail(signal, rate, 0.75 * duration, 0.5 * duration);
  const double mean = tail.transform(0.0).real();
  std::vector<double> rest(signal.begin(), signal.end());
  for (double& value : rest) value -= mean;
  return rest;
}

/// The mode, and how near to it there is something else.
struct Mode {
  double frequency = 0.0;
  double separation = 0.0;  ///< Hz
  std::vector<SpectralPeak> neighbours;
};

Mode choose_mode(std::span<const double> signal, double rate, const RingDownOptions& options) {
  constexpr double kFewestPeriods = 8.0;
  const double lowest = kFewestPeriods * rate / static_cast<double>(signal.size());
  double from = lowest;
  double to = kHighest * rate;
  if (options.frequency) {
    from = (1.0 - kSearch) * *options.frequency;
    to = (1.0 + kSearch) * *options.frequency;
  }
  if (options.band) {
    from = std::max(options.frequency ? from : 0.0, options.band->first);
    to = std::min(to, options.band->second);
  }
  const ModePeak peak = find_mode(signal, rate, from, to);
  if (!(peak.frequency > 0.0)) {
    throw InputError("range of frequencies", fmt::format("{:g} to {:g} Hz", from, to),
                     "must hold a peak of the spectrum: no decay found");
  }
  if (peak.frequency < lowest) {
    throw InputError(
        "record", fmt::format("{:g} s", static_cast<double>(signal.size()) / rate),
        fmt::format("must hold {} periods of {:g} Hz: too short", kFewestPeriods, peak.frequency));
  }
  Mode mode{
      .frequency = peak.frequency, .separation = peak.frequency, .neighbours = peak.neighbours};
  if (options.band) {
    mode.separation =
        std::min(peak.frequency - options.band->first, options.band->second - peak.frequency);
    // A peak at the very edge of the band: the spectrum rises beyond it.
    if (mode.separation < 1.0 / (static_cast<double>(signal.size()) / rate)) {
      throw InputError("band", fmt::format("peak at {:g} Hz", peak.frequency),
                       "must hold the mode's peak inside, not at its edge");
    }
    return mode;
  }
  for (const SpectralPeak& other : peak.neighbours) {
    mode.separation = std::min(mode.separation, std::abs(other.frequency - peak.frequency));
  }
  return mode;
}

DecayTask task_for(std::span<const double> signal, double rate, int derivatives, const Mode& mode,
                   const RingDownOptions& options) {
  const double reach = std::min(mode.separation / 2.0, kWidest * mode.frequency);
  DecayTask task{.signal = signal, .rate = rate, .derivatives = derivatives};
  task.to = static_cast<double>(signal.size() - 1) / rate;
  task.lowest = mode.frequency - reach;
  task.highest = mode.frequency + reach;
  task.shortest = std::max(options.least_periods / mode.frequency, kLines / mode.separation);
  task.largest_fall = options.largest_fall;
  task.wanted_std = options.wanted_std;
  task.largest_std = options.largest_std;
  for (const SpectralPeak& other : mode.neighbours) task.others.push_back(other.frequency);
  if (!options.from) {
    task.from = start_of_decay(signal, rate, mode.frequency,
                               std::max(4.0 / mode.frequency, 2.0 / mode.separation));
  }
  if (task.to - task.from < 1.5 * task.shortest) {
    throw InputError("free decay", fmt::format("{:g} s", task.to - task.from),
                     fmt::format("must last {:g} s at least at {:g} Hz: too short",
                                 1.5 * task.shortest, mode.frequency),
                     "Give the band, or the time where the decay begins, if they are not what was "
                     "found.");
  }
  return task;
}

[[noreturn]] void throw_no_decay(const DecayTask& task, const Mode& mode, WalkEnd end) {
  const std::string what = fmt::format("oscillation at {:.6g} Hz", mode.frequency);
  if (end == WalkEnd::kNoise) {
    throw InputError(what, "no decay found",
                     fmt::format("must decay, with a damping ratio known to {:g} % at least: the "
                                 "signal-to-noise ratio is too low, or the amplitude constant",
                                 100.0 * task.largest_std),
                     "Give the mode's frequency and the time range of the decay.");
  }
  throw InputError(what, "no decay found", "must be one decaying oscillation",
                   "Give the mode's frequency, its band and the time range of the decay.");
}

void add_point(const DecayWindow& window, const DecayPoint& point, double offset,
               RingDown& result) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  result.time.push_back(offset + window.centre);
  result.amplitude.push_back(point.amplitude);
  result.amplitude_std.push_back(point.amplitude_std);
  result.frequency.push_back(point.omega / kTwoPi);
  result.frequency_std.push_back(point.omega_std / kTwoPi);
  result.damping_ratio.push_back(point.damping);
  result.damping_ratio_std.push_back(point.damping_std);
  result.loss.push_back(point.loss);
  result.loss_std.push_back(point.loss_std);
  result.window.push_back(window.length);
}

void warn(const DecayTask& task, const Mode& mode, const DecayWalk& walk, double offset,
          bool banded, RingDown& result) {
  if (!banded && !mode.neighbours.empty()) {
    std::string names;
    for (const SpectralPeak& other : mode.neighbours) {
      names += fmt::format("{}{:.5g} Hz", names.empty() ? "" : ", ", other.frequency);
    }
    result.warnings.push_back(
        {"other_peaks", fmt::format("The spectrum has other peaks near {:.5g} Hz: {}. The windows "
                                    "are {:.3g} s or longer to keep them out.",
                                    mode.frequency, names, task.shortest)});
  }
  const DecayWindow& first = walk.windows.front();
  if (first.length * first.decay > 1.2 * task.largest_fall) {
    result.warnings.push_back(
        {"decay_within_window",
         fmt::format("The amplitude falls by a factor of {:.2g} within a window of {:.3g} s, the "
                     "shortest that keeps out what is near {:.5g} Hz: damping may be biased where "
                     "it changes fast.",
                     std::exp(first.length * first.decay), first.length, mode.frequency)});
  }
  if (walk.end == WalkEnd::kRise || walk.end == WalkEnd::kLost) {
    result.warnings.push_back(
        {walk.end == WalkEnd::kRise ? "amplitude_rises" : "mode_lost",
         fmt::format("The decay ends at {:.4g} s: {}.", offset + walk.end_time,
                     walk.end == WalkEnd::kRise
                         ? "the amplitude rises there, by a second impact or the beat of two modes"
                         : "the mode cannot be followed further")});
  }
}

std::string reason_of(WalkEnd end) {
  switch (end) {
    case WalkEnd::kRecord:
      return "the record ends";
    case WalkEnd::kNoise:
      return "the rest is lost in noise";
    case WalkEnd::kRise:
      return "the amplitude rises";
    case WalkEnd::kLost:
      break;
  }
  return "the mode is lost";
}

int derivatives_of(const Dimension& measured) {
  if (measured == kLength) return 0;
  if (measured == kVelocity) return 1;
  if (measured == kAcceleration) return 2;
  throw InputError("measured quantity", dimension_name(measured),
                   "must be displacement, velocity or acceleration");
}

RingDown result_of(const DecayTask& task, const DecayWalk& walk, double offset) {
  RingDown result;
  for (const DecayWindow& window : walk.windows) {
    add_point(window, decay_point(window, task.derivatives, walk.noise_variance), offset, result);
  }
  result.from = result.time.front() - result.window.front() / 2.0;
  result.to = result.time.back() + result.window.back() / 2.0;
  result.noise_std = std::sqrt(walk.noise_variance);
  const bool to_the_end = walk.end == WalkEnd::kRecord || walk.end == WalkEnd::kNoise;
  result.summary.status = to_the_end ? Status::kConverged : Status::kNotConverged;
  result.summary.method = "local fits of a decaying oscillation";
  result.summary.reason = reason_of(walk.end);
  result.summary.residual = result.noise_std / walk.windows.front().amplitude;
  result.summary.iterations = static_cast<int>(result.size());
  return result;
}

}  // namespace

RingDown ring_down(std::span<const double> signal, double rate, const Dimension& measured,
                   const RingDownOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  check_options(options, rate);
  check_signal(signal);
  const Cut part = cut(signal, rate, options);
  check_signal(part.signal);
  const std::vector<double> motion = without_offset(part.signal, rate);
  const Mode mode = choose_mode(motion, rate, options);
  const DecayTask task = task_for(motion, rate, derivatives_of(measured), mode, options);
  if (looks_clipped(task.signal.subspan(static_cast<std::size_t>(task.from * rate)))) {
    throw InputError("signal", "clipped",
                     "must not stand still at its largest value again and again",
                     "Begin later, where the signal is within the range of the instrument.");
  }
  const DecayWalk walk = walk_along(task);
  if (walk.windows.empty()) throw_no_decay(task, mode, walk.end);
  RingDown result = result_of(task, walk, part.offset);
  result.measured = measured;
  warn(task, mode, walk, part.offset, options.band.has_value(), result);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
  result.summary.wall_seconds = elapsed.count();
  return result;
}

RingDown ring_down(const Recording& recording, std::string_view channel,
                   const RingDownOptions& options) {
  check_recording(recording);
  const Channel& chosen = recording.channel(channel);
  const bool moves = chosen.dimension == kVelocity || chosen.dimension == kAcceleration;
  const Dimension measured = moves ? *chosen.dimension : kLength;
  const std::span<const double> signal = recording.signal(channel, measured);
  if (!recording.axis.even()) {
    throw InputError(recording.source + ": times", "uneven", "must be evenly spaced",
                     "Resample the record.");
  }
  RingDownOptions shifted = options;
  const double start = recording.axis.start;
  if (shifted.from) *shifted.from -= start;
  if (shifted.to) *shifted.to -= start;
  RingDown result;
  try {
    result = ring_down(signal, recording.sampling_rate(), measured, shifted);
  } catch (const InputError& error) {
    throw error.renamed(
        fmt::format("{}: channel '{}': {}", recording.source, channel, error.name()));
  }
  for (double& time : result.time) time += start;
  result.from += start;
  result.to += start;
  return result;
}

}  // namespace microslip
