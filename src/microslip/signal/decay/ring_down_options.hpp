// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "microslip/signal/decay/shape_course.hpp"

namespace microslip {

/// How ring_down() finds and follows the mode.
struct RingDownOptions {
  /// Near which the mode is sought, within 10 %, Hz: the nearest peak of the spectrum there that
  /// has a third of the height of the highest there. Without it: the highest peak of the spectrum.
  std::optional<double> frequency = {};
  /// Hz, low and high: the mode is sought inside, and the rest is filtered out. Without it the
  /// windows are so long that the other peaks of the spectrum move ζ by no more than `wanted_std`.
  std::optional<std::pair<double, double>> band = {};
  /// Where the free decay begins and ends, s on the axis of the recording. Without them: see
  /// DecayStart, and the end of the record.
  std::optional<double> from = {};
  std::optional<double> to = {};  ///< where it ends
  /// The windows are as short as this many periods where noise and other modes allow; from 3.
  double least_periods = 6.0;
  /// ln of the ratio of amplitudes over the shortest window, where the record lasts eight of them;
  /// above 0, up to largest_fall. Over a smaller fall any small disturbance looks like damping.
  double least_fall = 0.4;
  /// ln of the ratio of amplitudes over the longest window; above 0, up to 6. A longer window gives
  /// less scatter and more bias where the exponent of D(A) changes fast.
  double largest_fall = 2.0;
  /// Windows are as long as this standard deviation of ζ by noise, over ζ, needs, and as this
  /// change of ζ by other modes; above 0.
  double wanted_std = 0.005;
  /// The decay ends where the longest window exceeds this; above 0.
  double largest_std = 0.1;
  /// How much each channel moves in the mode as its frequency changes, one per channel; empty where
  /// shapes are fixed.
  std::vector<ShapeCourse> shapes = {};
};

}  // namespace microslip
