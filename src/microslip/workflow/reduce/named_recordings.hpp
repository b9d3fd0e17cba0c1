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

/// The recordings of a file, each named as the file was by the caller, not as the one that it was
/// made from; with the name of the recording where it holds several.
/// @param found     read_recordings() of the file.
/// @param path      of the file.
/// @param warnings  gets what the reader had to forgive.
[[nodiscard]] std::vector<Recording> named_recordings(Recordings found, const std::string& path,
                                                      std::vector<Warning>& warnings);

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
