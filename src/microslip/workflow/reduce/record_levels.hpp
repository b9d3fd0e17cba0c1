// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/observe/record_cycles.hpp"
#include "microslip/workflow/reduce/force_records.hpp"

/// @file
/// Recordings of force and displacement to levels.csv.

namespace microslip {

/// Inputs and options of find_record_levels().
struct RecordLevelsOptions {
  std::vector<std::string> records;   ///< paths of recordings of one joint
  JointChannels channels = {};        ///< of each of them
  RecordingReadOptions reading = {};  ///< of the recordings
};

/// The cycles of a record.
struct CyclesOfRecord {
  std::string source;              ///< of the record
  double start = 0.0;              ///< time of its first sample, s
  double time_step = 0.0;          ///< s
  RecordCycles found;              ///< record_cycles()
  std::vector<double> times = {};  ///< of the samples where they are uneven, s

  /// Time of a sample, s.
  [[nodiscard]] double time_of(std::size_t sample) const {
    return times.empty() ? start + static_cast<double>(sample) * time_step : times[sample];
  }
};

/// Result of find_record_levels(): at least one cycle.
struct RecordLevels {
  std::vector<CyclesOfRecord> records = {};  ///< in the order of the files
  std::vector<InputHash> inputs = {};        ///< the files
  std::vector<Warning> warnings = {};        ///< of files, cycles and flags

  /// Of all records.
  [[nodiscard]] std::size_t count() const;
};

/// Reads recordings and finds their closed cycles.
/// @throws FileError, FormatError  as read_recordings().
/// @throws InputError  as read_force_records() and check_records(), naming the record; where no
///                     cycle closes in any of them, or none stands out of the noise.
[[nodiscard]] RecordLevels find_record_levels(const RecordLevelsOptions& options);
/// As above, of records that were read before. @throws InputError  where no cycle closes.
[[nodiscard]] RecordLevels find_record_levels(ForceRecords read);

/// The text of levels.csv, one row per cycle, with warnings in its comment.
[[nodiscard]] std::string levels_text(const RecordLevels& found, std::string_view command);

/// The summary.
[[nodiscard]] std::string describe_record_levels(const RecordLevels& found);

}  // namespace microslip
