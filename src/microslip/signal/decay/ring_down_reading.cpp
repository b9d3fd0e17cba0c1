// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/ring_down_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include "microslip/base/codes.hpp"

namespace microslip {
namespace {

constexpr double kLeaks = 0.02;    // of ζ
constexpr double kMatters = 0.05;  // of ζ

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

std::string_view second_code(const DecayTrack& track) {
  return track.second->steady ? "steady_tone" : "beats";
}

/// Relative shift of ζ of a window by a second oscillation; 0 where it does not exceed leakage or
/// noise.
double shift_that_counts(const DecayTrack& track, std::size_t i) {
  constexpr double kSure = 2.0;
  if (!track.second) return 0.0;
  const DecayWindow& window = track.walk.windows[i];
  const DecayPoint noise = decay_point(window, track.task.measured, track.walk.noise_variance);
  const double moved = std::abs(track.second->beside_joint
                                    ? track.subtracted[i]
                                    : relative_shift(*track.second, window, track.task.measured));
  return moved > std::max(kLeaks, kSure * noise.damping_std / noise.damping) ? moved : 0.0;
}

void flag_windows(const DecayTrack& track, std::vector<std::string>& flags) {
  flag_clipped(track, track, flags);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (relative_leakage(track.walk.windows[i]) > kLeaks) add_code(flags[i], "neighbour_leaks");
    const DecayPoint& own = track.points[i];
    const DecayPoint noise =
        decay_point(track.walk.windows[i], track.task.measured, track.walk.noise_variance);
    if (shift_that_counts(track, i) > 0.0) add_code(flags[i], second_code(track));
    const double spread = std::sqrt(
        std::max(0.0, own.damping_std * own.damping_std - noise.damping_std * noise.damping_std));
    if (spread > kMatters * own.damping) add_code(flags[i], "window_matters");
  }
}

std::string_view unit_of(int derivatives) {
  constexpr std::string_view kUnits[] = {"m", "m/s", "m/s²"};
  return kUnits[derivatives];
}

std::string names_of(const std::vector<SpectralPeak>& peaks) {
  std::string names;
  for (const SpectralPeak& peak : peaks) {
    names += fmt::format("{}{:.5g} Hz ({:.2g} of its amplitude)", names.empty() ? "" : ", ",
                         peak.frequency, peak.height);
  }
  return names;
}

/// Warns of the peaks that are near enough to lengthen the windows.
void warn_of_neighbours(const DecayTrack& track, bool banded, RingDown& result) {
  constexpr double kTall = 0.03;
  const double reach = track.band().second - track.frequency;
  std::vector<SpectralPeak> near;
  for (const SpectralPeak& other : track.task.others) {
    const double distance = std::abs(other.frequency - track.frequency);
    if (other.height >= kTall && distance < 2.0 * reach) near.push_back(other);
  }
  if (!banded && !near.empty()) {
    result.warnings.push_back(
        {"other_peaks",
         fmt::format("The spectrum has other peaks near {:.5g} Hz: {}. The windows are {:.3g} s or "
                     "longer to separate them.",
                     track.frequency, names_of(near), std::ranges::min(result.window))});
  }
  std::size_t leaking = 0;
  double worst = 0.0;
  for (const DecayWindow& window : track.walk.windows) {
    worst = std::max(worst, relative_leakage(window));
    if (relative_leakage(window) > kLeaks) ++leaking;
  }
  if (leaking == 0) return;
  const SpectralPeak& nearest = *std::ranges::min_element(
      track.task.others, {},
      [&](const SpectralPeak& other) { return std::abs(other.frequency - track.frequency); });
  result.warnings.push_back(
      {"neighbour_leaks",
       fmt::format("Other modes, the nearest at {:.5g} Hz, move the damping of {:.5g} Hz by up to "
                   "{:.2g} % in {} of {} windows: too near to be separated while the mode decays. "
                   "The standard deviations include it; another sensor may show less of them.",
                   nearest.frequency, track.frequency, 100.0 * worst, leaking,
                   track.walk.windows.size())});
}

std::string second_text(const DecayTrack& track, std::size_t moved, double worst) {
  const SecondOscillation& second = *track.second;
  const double frequency = second.omega / (2.0 * std::numbers::pi);
  const std::string what =
      second.steady
          ? fmt::format(
                "A steady tone of {:.5g} Hz, {:.3g} {} at this sensor ({:.2g} of the first "
                "amplitude),",
                frequency, second.amplitude, unit_of(track.task.measured.derivatives), second.ratio)
          : fmt::format(
                "A second oscillation at {:.6g} Hz, {:.2g} of the first amplitude and with "
                "a damping ratio of {:.2g},",
                frequency, second.ratio, second.decay / second.omega);
  if (second.beside_joint) {
    return fmt::format(
        "{} moved the damping of {:.6g} Hz by up to {:.2g} % in {} of {} windows. It is "
        "subtracted, "
        "as that of a mode without joints, and the standard deviations include what is not known "
        "of it.",
        what, track.frequency, 100.0 * worst, moved, track.walk.windows.size());
  }
  return fmt::format(
      "{} moves the damping of {:.6g} Hz by up to {:.2g} % in {} of {} windows: no window is "
      "long enough to separate them. The standard deviations include it; alone the mode would have "
      "a "
      "damping ratio of {:.4g}.",
      what, track.frequency, 100.0 * worst, moved, track.walk.windows.size(),
      decay_point(second.mode_at(track.walk.windows.front().centre), track.task.measured, 0.0)
          .damping);
}

void warn_of_fall(const DecayTrack& track, RingDown& result) {
  const DecayWindow& first = track.walk.windows.front();
  if (first.length * first.decay <= 1.2 * track.task.largest_fall) return;
  result.warnings.push_back(
      {"decay_within_window",
       fmt::format("The amplitude falls by a factor of {:.2g} within a window of {:.3g} s, the "
                   "shortest that excludes what is near {:.5g} Hz: damping may be biased where "
                   "it changes fast.",
                   std::exp(first.length * first.decay), first.length, track.frequency)});
}

void warn_of_end(const DecayTrack& track, RingDown& result) {
  if (track.walk.end != WalkEnd::kRise && track.walk.end != WalkEnd::kLost) return;
  const bool rises = track.walk.end == WalkEnd::kRise;
  result.warnings.push_back(
      {rises ? "amplitude_rises" : "mode_lost",
       fmt::format("The decay ends at {:.4g} s: {}.", track.offset + track.walk.end_time,
                   rises ? "the amplitude rises there, by a second impact or the beat of two modes"
                         : "the mode cannot be followed further")});
}

void warn_of_frequency(RingDown& result) {
  constexpr double kFixed = 0.02;
  const auto [low, high] = std::ranges::minmax_element(result.frequency);
  const double range = *high / *low - 1.0;
  if (range <= kFixed) return;
  result.warnings.push_back(
      {"frequency_moves",
       fmt::format(
           "The frequency moves by {:.2g} % over the decay, {:.5g} to {:.5g} Hz: the mode's "
           "shape is then not fixed, and modal mass and joint ratio of the stuck mode are not "
           "those of the large amplitudes.",
           100.0 * range, *low, *high)});
}

std::string reason_of(WalkEnd end) {
  switch (end) {
    case WalkEnd::kRecord:
      return "the record ends";
    case WalkEnd::kNoise:
      return "the rest is below noise";
    case WalkEnd::kRise:
      return "the amplitude rises";
    case WalkEnd::kLost:
      break;
  }
  return "the mode cannot be followed";
}

Summary summary_of(const DecayTrack& track) {
  const bool to_the_end = track.walk.end == WalkEnd::kRecord || track.walk.end == WalkEnd::kNoise;
  Summary summary;
  summary.stop = to_the_end ? Stop::kConverged : Stop::kIncomplete;
  summary.method = "local fits of a decaying oscillation";
  summary.reason = reason_of(track.walk.end);
  summary.residual = std::sqrt(track.walk.noise_variance) / track.walk.windows.front().amplitude;
  summary.iterations = static_cast<int>(track.walk.windows.size());
  return summary;
}

}  // namespace

std::optional<Warning> warning_of_second(const DecayTrack& track) {
  std::size_t moved = 0;
  double worst = 0.0;
  for (std::size_t i = 0; i < track.walk.windows.size(); ++i) {
    const double shift = shift_that_counts(track, i);
    if (shift == 0.0) continue;
    ++moved;
    worst = std::max(worst, shift);
  }
  if (moved == 0) return std::nullopt;
  return Warning{std::string(second_code(track)), second_text(track, moved, worst)};
}

std::optional<Warning> warning_of_clipping(const DecayTrack& track) {
  const std::vector<double>& lacking = track.clipped;
  if (lacking.empty()) return std::nullopt;
  const DecayWindow& last = track.walk.windows[lacking.size() - 1];
  return Warning{
      "clipped",
      fmt::format("In the first {} of {} windows the range of the signal is up to {:.2g} % below "
                  "that of its fundamental: clipped by the instrument (the peaks then stay at one "
                  "level as the decay goes on), or flattened by macro-slip. Clipping makes damping "
                  "too small, which the standard deviations do not include: begin at {:.4g} s, or "
                  "widen the range of the channel.",
                  lacking.size(), track.walk.windows.size(), 100.0 * std::ranges::max(lacking),
                  track.offset + last.centre + last.length / 2.0)};
}

void flag_clipped(const DecayTrack& sensor, const DecayTrack& track,
                  std::vector<std::string>& flags) {
  const std::size_t count = sensor.clipped.size();
  if (count == 0) return;
  const double until = sensor.offset + sensor.walk.windows[count - 1].centre;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const bool later = track.offset + track.walk.windows[i].centre > until;
    if (!later) add_code(flags[i], "clipped");
  }
}

RingDown ring_down_of(const DecayTrack& track, const std::vector<DecayPoint>& points,
                      std::vector<std::string> flags, const Dimension& measured, bool banded) {
  RingDown result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    add_point(track.walk.windows[i], points[i], track.offset, result);
  }
  flag_windows(track, flags);
  result.flags = std::move(flags);
  result.from = result.time.front() - result.window.front() / 2.0;
  result.to = result.time.back() + result.window.back() / 2.0;
  result.start = track.offset + track.task.from;
  result.start_by = track.start_by;
  result.blow = track.blow;
  result.band = track.band();
  result.noise_std = std::sqrt(track.walk.noise_variance);
  result.measured = measured;
  result.summary = summary_of(track);
  if (const auto warning = warning_of_clipping(track)) result.warnings.push_back(*warning);
  warn_of_neighbours(track, banded, result);
  if (const auto warning = warning_of_second(track)) result.warnings.push_back(*warning);
  warn_of_fall(track, result);
  warn_of_end(track, result);
  warn_of_frequency(result);
  return result;
}

}  // namespace microslip
