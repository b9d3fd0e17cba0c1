// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/io/recordings/assumed_units.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// Contents of a file of recordings: channels that share an axis are one recording.
struct Recordings {
  std::vector<Recording> recordings;  ///< in the order of the file
  std::vector<Warning> warnings;      ///< what the reader had to forgive
  bool rate_used = false;  ///< whether RecordingReadOptions::rate placed the points of any
};

/// How files of recordings are read.
struct RecordingReadOptions {
  /// Read what a file has where it ends before all that it announces, with a warning. Otherwise
  /// that is an error.
  bool allow_truncated = false;
  /// Where nothing in a file tells over what its values are, take its points to be 1 s apart, with
  /// a warning: for what depends on their order alone, as dry friction does. Otherwise that is an
  /// error.
  bool allow_untimed = false;
  /// The rate, Hz, above 0, of points that nothing in the file places. A file that has times or a
  /// rate of its own for all of them is refused, whatever allow_untimed is.
  std::optional<double> rate = {};
  /// Bytes done of all bytes.
  Progress progress = {};
  /// For what the file gives no unit. read_recordings() gives them to the channels, whatever the
  /// format; a reader of one format uses them for the axis alone.
  AssumedUnits assumed_units = {};
  /// Of a table of text take no column for the axis: all are channels over the numbers of the rows,
  /// as those of a sweep, whose frequencies may fall.
  bool no_axis = false;
};

}  // namespace microslip
