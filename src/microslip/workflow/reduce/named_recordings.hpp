// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Recordings of several files.

namespace microslip {

/// The records of a file, each named as the file was by the caller, not as the one that it was made
/// from; with the name of the recording where it holds several.
/// @param warnings  gets what the reader had to forgive.
/// @throws Error  as read_recordings().
[[nodiscard]] std::vector<Recording> read_named_recordings(const std::string& path,
                                                           const RecordingReadOptions& options,
                                                           std::vector<Warning>& warnings);

/// As above, of a file that was opened before.
[[nodiscard]] std::vector<Recording> read_named_recordings(const TestFile& file,
                                                           const RecordingReadOptions& options,
                                                           std::vector<Warning>& warnings);

/// The recordings of a file, named as read_named_recordings() does. @param path  of the file.
[[nodiscard]] std::vector<Recording> named_recordings(std::vector<Recording> recordings,
                                                      const std::string& path);

/// Checks that files which were opened before are those of the paths.
/// @throws InputError  where there are some, but not one for each path.
void check_opened(const std::vector<TestFile>& opened, const std::vector<std::string>& paths);

/// SHA-256 of the whole file that a recording is of, or a part of.
/// @param path  no "-". @throws FileError  where it cannot be read.
[[nodiscard]] std::string recording_sha256(const std::string& path);

/// Warnings of the readers of many recordings, in one list, without duplicates; of
/// very many the first, and how many there are.
[[nodiscard]] std::vector<Warning> joined_warnings(
    const std::vector<std::vector<Warning>>& warnings);

}  // namespace microslip
