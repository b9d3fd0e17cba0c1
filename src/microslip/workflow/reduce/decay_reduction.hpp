// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/decay/ring_down.hpp"
#include "microslip/signal/decay/ring_down_levels.hpp"

/// @file
/// The recording of a free decay to levels.

namespace microslip {

/// Inputs and options of reduce_decay().
struct DecayReduction {
  std::string recording;                             ///< path
  std::vector<std::string> channels = {};            ///< of one blow; empty for the only motion
  RingDownOptions analysis = {};                     ///< of the decay
  std::optional<RingDownLevelsOptions> levels = {};  ///< none for damping ratios alone
  double joint_ratio = 1.0;                          ///< of damping ratios alone, 1
  RecordingReadOptions reading = {};                 ///< of the recording
};

/// Result of reduce_decay().
struct ReducedDecay {
  std::string source;             ///< of the recording
  RingDown decay;                 ///< its analysis
  RingDownLevels levels;          ///< may be empty where the loss factor takes all
  std::vector<Warning> warnings;  ///< of reader, analysis and levels
  bool band_given;                ///< not chosen by the analysis
};

/// @throws FileError, FormatError, InputError  as the reader, ring_down() and levels_of(), and
///                                             where the channels are not there once.
[[nodiscard]] ReducedDecay reduce_decay(const DecayReduction& options);

/// The text of levels.csv, without D where the options had no levels.
[[nodiscard]] std::string levels_text(const ReducedDecay& reduced, std::string_view command);

/// The summary. @param reduced  with levels.
[[nodiscard]] std::string describe_decay(const ReducedDecay& reduced);

}  // namespace microslip
