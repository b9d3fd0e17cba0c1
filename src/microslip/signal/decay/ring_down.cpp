// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/ring_down.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/base/units.hpp"
#include "microslip/signal/decay/decay_track.hpp"
#include "microslip/signal/decay/ring_down_reading.hpp"
#include "microslip/signal/decay/ring_down_sensors.hpp"
#include "microslip/signal/recording/resampling.hpp"

namespace microslip {
namespace {

bool ended_early(const DecayTrack& track) {
  return track.walk.end == WalkEnd::kRise || track.walk.end == WalkEnd::kLost;
}

/// The range that is followed without the given band, where that is longer.
struct BetterBand {
  std::pair<double, double> band;  ///< Hz
  double end = 0.0;                ///< s on the axis
};

/// @param end  s: how far the mode was followed in the band that was given.
std::optional<BetterBand> better_band(std::span<const double> signal, double rate,
                                      const Dimension& measured, const RingDownOptions& options,
                                      double origin, double begin, double end) {
  constexpr double kLonger = 1.5;
  try {
    RingDownOptions free = options;
    free.band.reset();
    if (!free.frequency) {
      free.frequency = std::midpoint(options.band->first, options.band->second);
    }
    const DecayTrack track = follow_decay(signal, rate, measured, free, origin);
    if (track.walk.windows.empty()) return std::nullopt;
    const double reached = track.offset + track.walk.windows.back().centre;
    if (reached - begin < kLonger * (end - begin)) return std::nullopt;
    return BetterBand{track.band(), reached};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string better_text(const BetterBand& better) {
  return fmt::format(
      "With the band {:.6g} to {:.6g} Hz, the default where none is given, the "
      "mode is followed to {:.4g} s.",
      better.band.first, better.band.second, better.end);
}

/// Follows the decay; where the given band loses it, names one that does not.
DecayTrack follow(std::span<const double> signal, double rate, const Dimension& measured,
                  const RingDownOptions& options, double origin, std::vector<Warning>& warnings) {
  DecayTrack track = follow_decay(signal, rate, measured, options, origin);
  const bool found = !track.walk.windows.empty();
  if (options.band && (!found || ended_early(track))) {
    const double begin = track.offset + track.task.from;
    const double end = found ? track.offset + track.walk.windows.back().centre : begin;
    const auto better = better_band(signal, rate, measured, options, origin, begin, end);
    if (better && !found) throw_no_decay(track, better_text(*better));
    if (better) warnings.push_back({"band_loses_mode", better_text(*better)});
  }
  if (!found) throw_no_decay(track, {});
  return track;
}

/// A channel of motion, evenly sampled.
struct MotionSignal {
  std::span<const double> values;
  Dimension measured;
};

MotionSignal motion_of(const Recording& recording, std::string_view name) {
  const Channel& chosen = recording.channel(name);
  const bool moves = chosen.dimension == kVelocity || chosen.dimension == kAcceleration;
  const Dimension measured = moves ? *chosen.dimension : kLength;
  const std::span<const double> values = recording.signal(name, measured);
  if (!recording.axis.even()) throw uneven_times(recording);
  return {values, measured};
}

DecayTrack follow(const Recording& recording, std::string_view channel,
                  const RingDownOptions& options, std::vector<Warning>& warnings) {
  const MotionSignal motion = motion_of(recording, channel);
  try {
    return follow(motion.values, recording.sampling_rate(), motion.measured, options,
                  recording.axis.start, warnings);
  } catch (const InputError& error) {
    throw error.renamed(
        fmt::format("{}: channel '{}': {}", recording.source, channel, error.name()));
  }
}

RingDown result_of_one(const DecayTrack& track, const Dimension& measured,
                       const RingDownOptions& options, const std::vector<Warning>& warnings) {
  RingDown result = ring_down_of(track, track.points, std::vector<std::string>(track.points.size()),
                                 measured, options.band.has_value());
  if (options.band) result.band = *options.band;
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
  return result;
}

/// Median of the followed frequency of a sensor over that of another at the same time, less 1;
/// nothing where they are not followed at one time. Beside it its standard deviation.
struct FrequencyOffset {
  double off = 0.0;
  double deviation = 0.0;
};

std::optional<FrequencyOffset> frequency_offset(const DecayTrack& track, const DecayTrack& first) {
  std::vector<FrequencyOffset> offsets;
  const double shift = track.offset - first.offset;
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    const double time = track.walk.windows[i].centre + shift;
    const auto nearest = std::ranges::min_element(
        first.walk.windows, {}, [=](const DecayWindow& w) { return std::abs(w.centre - time); });
    if (std::abs(nearest->centre - time) > 0.5 * nearest->length) continue;
    const DecayPoint& there =
        first.points[static_cast<std::size_t>(nearest - first.walk.windows.begin())];
    const DecayPoint& here = track.points[i];
    offsets.push_back({here.omega / there.omega - 1.0,
                       std::hypot(here.omega_std, there.omega_std) / there.omega});
  }
  if (offsets.empty()) return std::nullopt;
  const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
  std::ranges::nth_element(offsets, middle, {}, &FrequencyOffset::off);
  return *middle;
}

/// The reason why a sensor shows another mode than the first; empty where it does not.
std::string other_mode_text(const DecayTrack& track, const DecayTrack& first) {
  // Sensors of one mode have one frequency. The windows of two walks lie up to half a window apart,
  // over which a softening mode may move by some tenths of a per cent.
  constexpr double kOtherMode = 0.01;
  constexpr double kSureOfIt = 2.0;
  const auto offset = frequency_offset(track, first);
  if (!offset || std::abs(offset->off) <= std::max(kOtherMode, kSureOfIt * offset->deviation)) {
    return {};
  }
  return fmt::format("{:+.2g} % off the frequency of the first: another mode", 100.0 * offset->off);
}

/// The tracks of the sensors that can be followed; the first must. The others are sought near the
/// peak of the first.
std::vector<SensorTrack> follow_all(const Recording& recording,
                                    std::span<const std::string> channels,
                                    const RingDownOptions& options,
                                    std::vector<Warning>& warnings) {
  std::vector<SensorTrack> tracks;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::string& channel = channels[i];
    (void)motion_of(recording, channel);
    try {
      RingDownOptions sought = options;
      if (!options.shapes.empty()) sought.shapes = {options.shapes[i]};
      if (!tracks.empty()) sought.frequency = tracks.front().track.frequency;
      DecayTrack track = follow(recording, channel, sought, warnings);
      const std::string other =
          tracks.empty() ? std::string() : other_mode_text(track, tracks.front().track);
      if (other.empty()) {
        tracks.push_back({channel, std::move(track)});
      } else {
        warnings.push_back(
            {"sensor_left_out",
             fmt::format("Left out: {}: channel '{}': it shows an oscillation at {:.5g} Hz, {}.",
                         recording.source, channel, track.frequency, other)});
      }
    } catch (const InputError& error) {
      if (tracks.empty()) throw;
      warnings.push_back({"sensor_left_out", fmt::format("Left out: {}", error.what())});
    }
  }
  return tracks;
}

void check_channels(std::span<const std::string> channels, const RingDownOptions& options) {
  if (channels.empty()) {
    throw InputError("channels", InputState{"missing"}, "must name at least one sensor");
  }
  if (!options.shapes.empty() && options.shapes.size() != channels.size()) {
    throw InputError("number of shapes", fmt::format("{}", options.shapes.size()),
                     fmt::format("must be that of the channels, {}", channels.size()));
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto before = channels.first(i);
    if (std::ranges::find(before, channels[i]) == before.end()) continue;
    throw InputError("channels", fmt::format("'{}' twice", channels[i]),
                     "must name each sensor once");
  }
}

}  // namespace

RingDown ring_down(std::span<const double> signal, double rate, const Dimension& measured,
                   const RingDownOptions& options) {
  const Stopwatch watch;
  std::vector<Warning> warnings;
  const DecayTrack track = follow(signal, rate, measured, options, 0.0, warnings);
  RingDown result = result_of_one(track, measured, options, warnings);
  result.summary.wall_seconds = watch.seconds();
  return result;
}

RingDown ring_down(const Recording& recording, std::string_view channel,
                   const RingDownOptions& options) {
  const std::string name(channel);
  return ring_down(recording, std::span<const std::string>(&name, 1), options);
}

RingDown ring_down(const Recording& recording, std::span<const std::string> channels,
                   const RingDownOptions& options) {
  const Stopwatch watch;
  check_recording(recording);
  check_channels(channels, options);
  std::vector<Warning> warnings;
  const std::vector<SensorTrack> tracks = follow_all(recording, channels, options, warnings);
  const Dimension measured = motion_of(recording, channels.front()).measured;
  RingDown result;
  if (tracks.size() == 1) {
    result = result_of_one(tracks.front().track, measured, options, warnings);
    result.sensors = {{.name = tracks.front().name}};
  } else {
    CombinedDecay all = combine_sensors(tracks);
    for (const SensorTrack& sensor : tracks) {
      flag_clipped(sensor.track, tracks[all.leader].track, all.flags);
    }
    result = ring_down_of(tracks[all.leader].track, all.points, std::move(all.flags), measured,
                          options.band.has_value());
    if (options.band) result.band = *options.band;
    result.sensors = std::move(all.sensors);
    for (const SensorTrack& sensor : tracks) {
      if (&sensor == &tracks[all.leader]) continue;
      for (auto& warning : {warning_of_clipping(sensor.track), warning_of_second(sensor.track)}) {
        if (!warning) continue;
        result.warnings.push_back({warning->code, sensor.name + ": " + warning->text});
      }
    }
    for (const auto* more : {&warnings, &all.warnings}) {
      result.warnings.insert(result.warnings.end(), more->begin(), more->end());
    }
    result.summary.method += fmt::format(", of {} sensors", tracks.size());
  }
  result.summary.wall_seconds = watch.seconds();
  return result;
}

}  // namespace microslip
