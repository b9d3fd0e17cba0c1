// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/decay_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/median.hpp"
#include "microslip/base/units.hpp"
#include "microslip/signal/decay/decay_clipping.hpp"
#include "microslip/signal/decay/decay_range.hpp"
#include "microslip/signal/decay/mode_peak.hpp"
#include "microslip/signal/decay/tapered_transform.hpp"

namespace microslip {
namespace {

constexpr double kLines = 6.0;   // of a window's resolution 1/T between a mode and what is kept out
constexpr double kSearch = 0.1;  // about the frequency that is given
constexpr double kWidest = 0.2;  // how far a mode's frequency may move, where nothing is near
constexpr double kHighest = 0.45;  // of the sampling rate
constexpr double kTall = 0.03;     // of the mode: a neighbour that its frequency must not reach

void check_positive(std::string_view name, double value, double most) {
  if (value > 0.0 && value <= most) return;
  throw InputError(name, value, fmt::format("must be above 0 and at most {:g}", most));
}

/// Of a mode near half of the sampling rate the samples show the mirror image too, at the rate less
/// its frequency, and of one above it this image alone.
[[noreturn]] void throw_coarse(std::string_view name, double frequency, double rate) {
  constexpr double kComfortable = 2.5;
  throw InputError(
      name, fmt::format("{:.5g} Hz", frequency),
      fmt::format("must be at most {:.5g} Hz, {:g} of the sampling rate of {:.5g} Hz: nearer to "
                  "half of it a mode and its mirror image are one",
                  kHighest * rate, kHighest, rate),
      fmt::format("Record with {:.3g} Hz or more and a filter against aliasing, or give the "
                  "frequency of a lower mode.",
                  kComfortable * frequency));
}

void check_options(const RingDownOptions& options, double rate) {
  if (!(rate > 0.0 && std::isfinite(rate))) {
    throw InputError("sampling rate", rate, "must be above 0 Hz and finite");
  }
  if (options.frequency) {
    const double frequency = *options.frequency;
    if (std::isfinite(frequency) && frequency > kHighest * rate) {
      throw_coarse("frequency", frequency, rate);
    }
    check_positive("frequency", frequency, kHighest * rate);
  }
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
  check_positive("least_fall", options.least_fall, options.largest_fall);
  check_positive("wanted_std", options.wanted_std, 1.0);
  check_positive("largest_std", options.largest_std, 1.0);
}

void check_signal(std::span<const double> signal) {
  constexpr std::size_t kFewest = 32;
  if (signal.size() < kFewest) {
    throw InputError("number of samples", fmt::format("{}", signal.size()),
                     fmt::format("must be at least {}: too short for a decay", kFewest));
  }
  const auto bad = std::ranges::find_if_not(signal, [](double y) { return std::isfinite(y); });
  if (bad == signal.end()) return;
  throw InputError(fmt::format("sample {}", bad - signal.begin() + 1), *bad, "must be finite");
}

/// The part of the signal between the options' times, with its offset.
struct Cut {
  std::span<const double> signal;
  double offset = 0.0;  ///< s, on the axis
};

Cut cut(std::span<const double> signal, double rate, const RingDownOptions& options,
        double origin) {
  const double duration = static_cast<double>(signal.size()) / rate;
  const double from = options.from.value_or(origin) - origin;
  const double to = options.to.value_or(origin + duration) - origin;
  if (!(from < to && from < duration && to > 0.0)) {
    throw InputError(
        "range", fmt::format("{:g} to {:g} s", origin + from, origin + to),
        fmt::format("must rise and overlap the record, {:g} to {:g} s", origin, origin + duration));
  }
  const double last = static_cast<double>(signal.size());
  const double first = std::clamp(std::ceil(from * rate), 0.0, last);
  const double end = std::clamp(std::floor(to * rate), first, last);
  return {signal.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first)),
          origin + first / rate};
}

/// The signal less its mean over the last half under cos⁴: there the oscillation is small, and the
/// taper lets next to nothing of it into the mean. An offset would pass for a large amplitude in
/// the short windows that locate the beginning of the decay, and its rest for one where little is
/// left of it.
std::vector<double> without_offset(std::span<const double> signal, double rate) {
  const double duration = static_cast<double>(signal.size() - 1) / rate;
  const TaperedWindow tail(signal, rate, 0.75 * duration, 0.5 * duration);
  const double mean = tail.transform(0.0).real();
  std::vector<double> rest(signal.begin(), signal.end());
  for (double& value : rest) value -= mean;
  return rest;
}

/// Where the options let the mode be, Hz.
std::pair<double, double> search_range(double lowest, double rate, const RingDownOptions& options) {
  double from = lowest;
  double to = kHighest * rate;
  if (options.frequency) {
    from = (1.0 - kSearch) * *options.frequency;
    to = std::min((1.0 + kSearch) * *options.frequency, 0.5 * rate);
  }
  if (options.band) {
    from = std::max(options.frequency ? from : 0.0, options.band->first);
    to = std::min(to, options.band->second);
  }
  return {from, to};
}

/// The peak in a range nearest to a frequency, of those of at least a third of the height of the
/// highest there; 0 where there is none.
double nearest_peak(std::span<const SpectralPeak> peaks, std::pair<double, double> range,
                    double frequency) {
  constexpr double kMeant = 1.0 / 3.0;
  double highest = 0.0;
  const auto inside = [&](const SpectralPeak& peak) {
    return peak.frequency >= range.first && peak.frequency <= range.second;
  };
  for (const SpectralPeak& peak : peaks) {
    if (inside(peak)) highest = std::max(highest, peak.height);
  }
  double nearest = 0.0;
  for (const SpectralPeak& peak : peaks) {
    if (!inside(peak) || peak.height < kMeant * highest) continue;
    if (std::abs(peak.frequency - frequency) < std::abs(nearest - frequency)) {
      nearest = peak.frequency;
    }
  }
  return nearest;
}

std::string highest_peak_text(std::span<const SpectralPeak> peaks) {
  if (peaks.empty()) return {};
  return fmt::format("The highest peak of all is at {:.5g} Hz.",
                     std::ranges::max_element(peaks, {}, &SpectralPeak::height)->frequency);
}

/// Refuses a peak above the range where modes are followed, and the edge of the range, where the
/// spectrum rises beyond it.
void check_sampled(std::span<const double> signal, double rate, double frequency,
                   std::pair<double, double> range) {
  const double highest = kHighest * rate;
  if (frequency > highest) throw_coarse("peak of the spectrum", frequency, rate);
  const double line = rate / static_cast<double>(signal.size());
  if (range.second < highest || frequency < highest - line) return;
  const double beyond = find_mode(signal, rate, frequency, 0.5 * rate);
  if (beyond > frequency) throw_coarse("peak of the spectrum", beyond, rate);
}

/// The peak where the options let the mode be; without a frequency the highest line.
double choose_frequency(std::span<const double> signal, double rate, const RingDownOptions& options,
                        std::span<const SpectralPeak> peaks) {
  constexpr double kFewestPeriods = 8.0;
  const double duration = static_cast<double>(signal.size()) / rate;
  const double lowest = kFewestPeriods / duration;
  const auto range = search_range(lowest, rate, options);
  const double frequency = options.frequency ? nearest_peak(peaks, range, *options.frequency)
                                             : find_mode(signal, rate, range.first, range.second);
  check_sampled(signal, rate, frequency, range);
  if (!(frequency > 0.0)) {
    throw InputError(
        "range of frequencies", fmt::format("{:g} to {:g} Hz", range.first, range.second),
        "must contain a peak of the spectrum: no decay found", highest_peak_text(peaks));
  }
  if (frequency < lowest) {
    throw InputError(
        "record", fmt::format("{:g} s", duration),
        fmt::format("must contain {} periods of {:g} Hz: too short", kFewestPeriods, frequency));
  }
  // A peak at the very edge of the band: the spectrum rises beyond it.
  if (options.band && std::min(frequency - options.band->first, options.band->second - frequency) <
                          1.0 / duration) {
    throw InputError("band", fmt::format("peak at {:g} Hz", frequency),
                     "must contain the mode's peak inside, not at its edge");
  }
  return frequency;
}

/// Refuses a track that has left the chosen peak: a higher one beside it attracts the windows.
void check_followed(const DecayTrack& track, const RingDownOptions& options,
                    std::span<const SpectralPeak> peaks) {
  if (track.walk.windows.empty() || peaks.empty()) return;
  std::vector<double> all;
  for (const DecayWindow& window : track.walk.windows) {
    all.push_back(window.omega / (2.0 * std::numbers::pi));
  }
  const double followed = median(std::move(all));
  const auto from = [](double frequency) {
    return [=](const SpectralPeak& peak) { return std::abs(peak.frequency - frequency); };
  };
  const SpectralPeak own = *std::ranges::min_element(peaks, {}, from(track.frequency));
  const SpectralPeak there = *std::ranges::min_element(peaks, {}, from(followed));
  const bool drawn = there.height > own.height && there.frequency != own.frequency;
  const bool outside = options.frequency && std::abs(followed / *options.frequency - 1.0) > kSearch;
  if (!drawn && !outside) return;
  throw InputError(
      fmt::format("oscillation at {:.6g} Hz", track.frequency), InputState{"not followed"},
      fmt::format("must outlast other oscillations: the windows show {:.6g} Hz{}", followed,
                  drawn ? fmt::format(", the higher peak at {:.6g} Hz", there.frequency) : ""),
      "Choose another sensor or another frequency, or give a band that excludes the other.");
}

/// How far the mode is from what is kept out: the edges of the band, or the next tall neighbours.
double separation_of(double frequency, const ModeNeighbours& neighbours,
                     const RingDownOptions& options) {
  if (options.band) {
    return std::min(frequency - options.band->first, options.band->second - frequency);
  }
  double separation = frequency;
  for (const SpectralPeak& other : neighbours.peaks) {
    if (other.height < kTall) continue;
    separation = std::min(separation, std::abs(other.frequency - frequency));
  }
  return separation;
}

std::span<const double> behind(std::span<const double> signal, double rate, double time) {
  const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(time * rate)));
  return signal.subspan(std::min(first, signal.size()));
}

std::span<const double> from_blow(const DecayTrack& track, double rate) {
  return behind(track.motion, rate, track.blow ? *track.blow - track.offset : 0.0);
}

/// The beginning of the decay, s from the first sample; sets how it was found.
double begin_of_decay(const DecayTrack& track, double rate, double separation, DecayStart& by) {
  const double f = track.frequency;
  if (!track.blow) {
    const double fall = start_of_decay(track.motion, rate, f, std::max(4.0 / f, 2.0 / separation));
    by = fall > 0.0 ? DecayStart::kFall : DecayStart::kRecord;
    return fall;
  }
  // A half-sine that excites the mode lasts less than 1.5 of its periods: longer, its spectrum has
  // its first zero below the mode.
  constexpr double kContact = 1.5;
  constexpr double kMargin = 0.1;  // possible rise by the beat of other modes
  const double free = *track.blow - track.offset + kContact / f;
  const double fall = start_of_decay(behind(track.motion, rate, free), rate, f,
                                     std::max(8.0 / f, 2.0 / separation), kMargin);
  by = fall > 0.0 ? DecayStart::kFall : DecayStart::kBlow;
  return free + fall;
}

[[noreturn]] void throw_too_short(double duration, double least, double frequency) {
  throw InputError("free decay", fmt::format("{:g} s", duration),
                   fmt::format("must last at least {:g} s at {:g} Hz: too short", least, frequency),
                   "Give the band, or the time where the decay begins, if they are not what was "
                   "found.");
}

void set_task(DecayTrack& track, double rate, const MeasuredMotion& measured,
              const RingDownOptions& options) {
  const double f = track.frequency;
  DecayTask& task = track.task;
  task = {.signal = track.motion, .rate = rate, .measured = measured};
  task.to = static_cast<double>(track.motion.size() - 1) / rate;
  double separation = separation_of(f, neighbours_of(from_blow(track, rate), rate, f), options);
  if (!options.from) task.from = begin_of_decay(track, rate, separation, track.start_by);
  task.shortest = options.least_periods / f;
  if (options.band) task.shortest = std::max(task.shortest, kLines / separation);
  if (task.to - task.from < 1.5 * task.shortest) {
    throw_too_short(task.to - task.from, 1.5 * task.shortest, f);
  }
  const ModeNeighbours neighbours = neighbours_of(behind(track.motion, rate, task.from), rate, f);
  separation = separation_of(f, neighbours, options);
  const double reach = std::min(separation / 2.0, kWidest * f);
  task.lowest = f - reach;
  task.highest = std::min(f + reach, 0.5 * rate);
  task.others = neighbours.peaks;
  // Over the examined stretch the mode falls by e^1.8.
  task.first_length =
      std::min(std::max(neighbours.length / 8.0, 4.0 / separation), (task.to - task.from) / 4.0);
  task.least_fall = options.least_fall;
  task.largest_fall = options.largest_fall;
  task.wanted_std = options.wanted_std;
  task.largest_std = options.largest_std;
}

int derivatives_of(const Dimension& measured) {
  if (measured == kLength) return 0;
  if (measured == kVelocity) return 1;
  if (measured == kAcceleration) return 2;
  throw InputError("measured quantity", dimension_name(measured),
                   "must be displacement, velocity or acceleration");
}

/// Follows the mode without the oscillation beside it; as before where it cannot be followed then.
void follow_without_second(DecayTrack& track) {
  const std::vector<double> both = track.motion;
  for (std::size_t i = 0; i < both.size(); ++i) {
    track.motion[i] -= track.second->value_at(static_cast<double>(i) / track.task.rate);
  }
  DecayWalk walk = walk_along(track.task);
  if (walk.windows.empty()) {
    track.motion = both;
    track.task.signal = track.motion;
    track.second.reset();
    return;
  }
  track.walk = std::move(walk);
  track.points = points_of(track.task, track.walk.windows, track.walk.noise_variance);
  for (const DecayWindow& window : track.walk.windows) {
    const auto before = fit_decay_values(both, track.task.rate, window.centre, window.length,
                                         track.task.lowest, track.task.highest);
    const auto damping = [&](const DecayWindow& of) {
      return decay_point(of, track.task.measured, 0.0).damping;
    };
    track.subtracted.push_back(before ? damping(*before) / damping(window) - 1.0 : 1.0);
  }
}

}  // namespace

std::pair<double, double> DecayTrack::band() const {
  double shortest = task.to - task.from;
  for (const DecayWindow& window : walk.windows) shortest = std::min(shortest, window.length);
  const double reach = kLines / shortest;
  constexpr double kLowest =
      0.05;  // of the frequency: windows of six periods let through down to 0
  return {std::max(frequency - reach, kLowest * frequency),
          std::min(frequency + reach, 0.5 * task.rate)};
}

DecayTrack follow_decay(std::span<const double> signal, double rate, const Dimension& measured,
                        const RingDownOptions& options, double origin) {
  check_options(options, rate);
  check_signal(signal);
  const MeasuredMotion what{derivatives_of(measured),
                            options.shapes.empty() ? ShapeCourse{} : options.shapes.front()};
  const Cut part = cut(signal, rate, options, origin);
  check_signal(part.signal);
  DecayTrack track;
  track.offset = part.offset;
  track.motion = without_offset(part.signal, rate);
  if (!options.from) track.blow = find_blow(track.motion, rate);
  if (track.blow) *track.blow += track.offset;
  const std::vector<SpectralPeak> peaks = parted_peaks(from_blow(track, rate), rate);
  track.frequency = choose_frequency(from_blow(track, rate), rate, options, peaks);
  set_task(track, rate, what, options);
  if (looks_clipped(behind(track.motion, rate, track.task.from))) {
    throw InputError("signal", "clipped", "must not stay at its largest value repeatedly: clipped",
                     "Begin later, where the signal is within the range of the instrument.");
  }
  track.walk = walk_along(track.task);
  check_followed(track, options, peaks);
  track.points = points_of(track.task, track.walk.windows, track.walk.noise_variance);
  track.clipped =
      clipped_windows(track.motion, rate, track.walk.windows, std::sqrt(track.walk.noise_variance));
  const double onset = track.blow ? *track.blow - track.offset : 0.0;
  const auto before = track.task.signal.first(
      std::min(static_cast<std::size_t>(onset * rate), track.task.signal.size()));
  track.second =
      find_second_oscillation(track.task, track.walk.windows, track.walk.noise_variance, before);
  // A clipped decay is that of no mode with a joint.
  if (track.second && track.second->beside_joint) {
    if (track.clipped.empty()) {
      follow_without_second(track);
    } else {
      track.second.reset();
    }
  }
  add_second(track, track.walk.windows, track.points);
  return track;
}

void add_second(const DecayTrack& track, std::span<const DecayWindow> windows,
                std::span<DecayPoint> points) {
  if (!track.second) return;
  if (!track.second->beside_joint) {
    add_shifts(*track.second, windows, track.task.measured, points);
    return;
  }
  // What was subtracted is known to such a share: on average over the windows, as a shift changes
  // its sign with the phase of the beat.
  constexpr double kKnown = 0.15;
  double squares = 0.0;
  for (const double shift : track.subtracted) squares += shift * shift;
  const double rest = kKnown * std::sqrt(squares / static_cast<double>(track.subtracted.size()));
  for (DecayPoint& point : points) {
    point.damping_std = std::hypot(point.damping_std, rest * point.damping);
    point.loss_std = std::hypot(point.loss_std, rest * point.loss);
  }
}

void throw_no_decay(const DecayTrack& track, std::string_view remedy) {
  const std::string what = fmt::format("oscillation at {:.6g} Hz", track.frequency);
  if (track.walk.end == WalkEnd::kNoise) {
    throw InputError(
        what, "no decay found",
        fmt::format("must decay, with a damping ratio known to {:g} % or better: the "
                    "signal-to-noise ratio is too low, or the amplitude constant",
                    100.0 * track.task.largest_std),
        remedy.empty() ? "Give the mode's frequency and the time range of the decay." : remedy);
  }
  throw InputError(what, "no decay found", "must be one decaying oscillation",
                   remedy.empty()
                       ? "Give the mode's frequency, its band and the time range of the decay."
                       : remedy);
}

}  // namespace microslip
