// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/signal/decay/decay_spread.hpp"
#include "microslip/signal/decay/decay_walk.hpp"
#include "microslip/signal/decay/ring_down_options.hpp"
#include "microslip/signal/decay/ring_down_result.hpp"
#include "microslip/signal/decay/second_oscillation.hpp"

/// @file
/// One signal from its samples to the windows of a decay. Internal to signal.

namespace microslip {

/// A sensor's decay as it was followed. `task` sees `motion`: moved, not copied.
struct DecayTrack {
  DecayTrack() = default;
  DecayTrack(DecayTrack&&) = default;
  DecayTrack& operator=(DecayTrack&&) = default;
  DecayTrack(const DecayTrack&) = delete;
  DecayTrack& operator=(const DecayTrack&) = delete;
  ~DecayTrack() = default;

  std::vector<double> motion;  ///< the signal between the options' times, less its offset
  DecayTask task;              ///< its `others` are the mode's neighbours
  DecayWalk walk;
  std::vector<DecayPoint>
      points;  ///< one per window; standard deviations with those of the choices
  std::vector<double> clipped = {};              ///< see clipped_windows()
  std::optional<SecondOscillation> second = {};  ///< what beats with the mode
  /// Relative shift of ζ in each window by what was subtracted from `motion`; empty where nothing
  /// was.
  std::vector<double> subtracted = {};
  double frequency = 0.0;  ///< Hz, of the highest line
  double offset = 0.0;     ///< s on the axis of the recording, of the first sample of `motion`
  DecayStart start_by = DecayStart::kGiven;
  std::optional<double> blow = {};  ///< s on the axis

  /// The pass band of the windows, Hz.
  [[nodiscard]] std::pair<double, double> band() const;
};

/// Follows a signal; without windows where no decay is found.
/// @param options  `shapes` is empty or that of the signal.
/// @param origin   s on the axis of the recording, of the first sample.
/// @throws InputError  as ring_down().
[[nodiscard]] DecayTrack follow_decay(std::span<const double> signal, double rate,
                                      const Dimension& measured, const RingDownOptions& options,
                                      double origin);

/// Adds to the standard deviations what a second oscillation does to windows of the track's signal.
void add_second(const DecayTrack& track, std::span<const DecayWindow> windows,
                std::span<DecayPoint> points);

/// Throws the error of a track without windows. @param remedy  empty: the usual one.
[[noreturn]] void throw_no_decay(const DecayTrack& track, std::string_view remedy);

}  // namespace microslip
