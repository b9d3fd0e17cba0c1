// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/signal/recording/recording.hpp"

/// @file
/// Which channels of a file are the decay. Internal to workflow.

namespace microslip {

/// One decay: channels of one recording, one at least.
struct DecaySignal {
  const Recording* recording;
  std::vector<std::string> channels;
};

/// The channels of those names, all of one recording; without names the only motion there is.
/// @param recordings  outlive the result. @param file  for messages.
/// @throws InputError  where one is not there once, or they are of several recordings.
[[nodiscard]] DecaySignal choose_signals(const std::vector<Recording>& recordings,
                                         const std::vector<std::string>& names,
                                         const std::string& file);

}  // namespace microslip
