// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/io/config/named_values.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/observe/force_record.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Recordings of the force and the displacement of a joint.

namespace microslip {

/// Which channels of a recording are those of a joint.
struct JointChannels {
  std::string force = {};         ///< name; empty for the only force there is
  std::string displacement = {};  ///< name; empty for the only displacement there is
};

/// Force and displacement of a recording.
/// @throws InputError  naming recording and channel: missing, not the only one, of another
///                     quantity, complex or not over time. @return of time step 0 where times are
///                     uneven: friction depends on the order of the samples alone.
[[nodiscard]] ForceRecord force_record(const Recording& recording, const JointChannels& channels);

/// A record and where it is from.
struct NamedForceRecord {
  std::string source;              ///< file, and recording where it holds several
  ForceRecord record;              ///< as read
  double start = 0.0;              ///< time of its first sample, s
  double input = 0.0;              ///< number of its file, from 1
  std::vector<double> times = {};  ///< of the samples where they are uneven, s
};

/// Contents of several files.
struct ForceRecords {
  std::vector<NamedForceRecord> records = {};  ///< in the order of the files
  std::vector<InputHash> inputs = {};          ///< the files
  std::vector<Warning> warnings = {};          ///< what the reader had to forgive
};

/// Of a file of several recordings those without force or displacement are left out, with a
/// warning, beside one that has both.
/// @throws FileError, FormatError  as read_recordings(). @throws InputError  as force_record().
[[nodiscard]] ForceRecords read_force_records(const std::vector<std::string>& paths,
                                              const JointChannels& channels,
                                              const RecordingReadOptions& reading);

/// As above for files that were opened before.
[[nodiscard]] ForceRecords read_force_records(const std::vector<TestFile>& files,
                                              const JointChannels& channels,
                                              const RecordingReadOptions& reading);

/// Errors of a record name it.
template <typename Call>
void of_record(const std::string& source, const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    throw error.renamed(source + ": " + std::string(error.name()));
  }
}

}  // namespace microslip
