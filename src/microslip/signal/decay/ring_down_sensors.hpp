// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/signal/decay/decay_track.hpp"
#include "microslip/signal/decay/ring_down_result.hpp"

/// @file
/// One decay seen by several sensors. Internal to signal.

namespace microslip {

struct SensorTrack {
  std::string name;
  DecayTrack track;  ///< with windows
};

/// The combined result of the sensors, in the windows of one of them.
struct CombinedDecay {
  std::size_t leader = 0;          ///< index of the sensor whose windows are used
  std::vector<DecayPoint> points;  ///< one per window; amplitudes of the first sensor
  std::vector<std::string> flags;  ///< one per window: sensors_differ, shape_moves
  std::vector<RingDownSensor> sensors;
  std::vector<Warning> warnings;
};

/// See ring_down() of several channels. @param tracks  two at least.
[[nodiscard]] CombinedDecay combine_sensors(const std::vector<SensorTrack>& tracks);

}  // namespace microslip
