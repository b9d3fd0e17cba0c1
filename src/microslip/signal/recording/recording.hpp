// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"

namespace microslip {

/// The axis of the values of a recording: usually time, or the frequency of a transformed signal.
/// Point i lies at start + i·step, or at values[i] where the points are not evenly spaced.
struct Axis {
  Dimension dimension = kTime;  ///< of the points
  double start = 0.0;           ///< SI; the time zero of a record is where this axis has its 0
  double step = 0.0;            ///< SI, above 0 where the points are evenly spaced
  std::vector<double> values;   ///< SI; empty where they are

  /// Whether the points are evenly spaced.
  [[nodiscard]] bool even() const { return values.empty(); }
  /// Point i, SI; NaN behind the last of those that are not evenly spaced.
  [[nodiscard]] double at(std::size_t i) const {
    if (even()) return start + static_cast<double>(i) * step;
    return i < values.size() ? values[i] : std::numeric_limits<double>::quiet_NaN();
  }

  /// Member by member.
  friend bool operator==(const Axis&, const Axis&) = default;
};

/// Further information of a file on a recording or a channel, by name: "description", "serial
/// number".
using Attributes = std::vector<std::pair<std::string, std::string>>;

/// One signal. Values are in SI where the unit is known.
struct Channel {
  std::string name;                    ///< no two the same in a recording
  std::optional<Dimension> dimension;  ///< none: the file has no unit; values are as in the file
  std::vector<double> values;          ///< one per point of the axis
  std::vector<double> imaginary;       ///< empty, or of the same length: the values are complex
  Attributes attributes;               ///< in addition to its values

  /// Member by member.
  friend bool operator==(const Channel&, const Channel&) = default;
};

/// A channel of a file that is none of a recording, because it has no value at some points.
struct LeftOutChannel {
  std::string name;    ///< in the file
  std::string reason;  ///< "20 of 500 values are missing or not finite, the first at point 481"
};

/// Channels measured together, over one axis; each has a value at each of its points.
struct Recording {
  std::string source;             ///< where it comes from, for messages and tables: "level_1.csv"
  Axis axis;                      ///< that its channels share
  std::vector<Channel> channels;  ///< one at least
  Attributes attributes;          ///< in addition to those of the channels
  /// Of the file, but not of this recording; for messages.
  std::vector<LeftOutChannel> left_out = {};

  /// The number of points.
  [[nodiscard]] std::size_t size() const {
    return channels.empty() ? axis.values.size() : channels.front().values.size();
  }

  /// 1/step, 1/s. Only for a recording over evenly spaced times.
  [[nodiscard]] double sampling_rate() const { return 1.0 / axis.step; }

  /// The channel of this name.
  /// @throws InputError  naming the source, the channel and those there are, where it is missing;
  ///                     the reason where it was left out.
  [[nodiscard]] const Channel& channel(std::string_view name) const;

  /// The values of a real channel over time, in SI.
  /// @throws InputError  naming the source and the channel, where it is missing, complex, not over
  ///                     time, without unit or of another dimension.
  [[nodiscard]] std::span<const double> signal(std::string_view name,
                                               const Dimension& expected) const;

  /// Sets the unit of the values of a channel without one; they become SI.
  /// @throws InputError  where the channel is missing or has a unit.
  void assume_unit(std::string_view name, const Unit& unit);
};

/// The names of its channels in quotes, between commas; "none" without any.
[[nodiscard]] std::string names_of_channels(const Recording& recording);

/// Takes out the channels that have a value which is not finite, into `left_out`, unless none would
/// remain.
/// @return  the reason of each, after its name in quotes.
std::vector<std::string> leave_out_incomplete(Recording& recording);

/// Checks that the recording is whole: a channel and two points at least, names unique and not
/// empty, lengths equal, a step above 0 or values that rise, everything finite.
/// @throws InputError  naming the source, the channel and the value.
void check_recording(const Recording& recording);

}  // namespace microslip
