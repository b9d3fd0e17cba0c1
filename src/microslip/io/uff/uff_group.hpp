// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/uff/uff_channel.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Datasets 58 that are a recording together. Internal to io.

namespace microslip {

/// Functions that follow each other over one axis.
struct UffGroup {
  Axis axis;
  std::vector<UffChannel> channels;

  /// Whether a function is over the axis of those that are there.
  [[nodiscard]] bool takes(const UffChannel& channel) const {
    return !channels.empty() && axis == channel.axis &&
           channels.front().values.size() == channel.values.size();
  }
  /// @param channel  the first, or one that takes() has room for.
  void add(UffChannel channel);
};

/// Its recording, without attributes.
/// @param group     with a channel at least.
/// @param source    of the recording.
/// @param warnings  gets those of doubtful units.
[[nodiscard]] Recording recording_of(UffGroup group, const std::string& source,
                                     std::vector<Warning>& warnings);

}  // namespace microslip
