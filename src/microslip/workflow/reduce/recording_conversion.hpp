// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/io/uff/uff_recording.hpp"

/// @file
/// Conversion of recordings from one format to another.

namespace microslip {

/// Leaves these channels in each recording, in this order; all where none is named.
/// @throws InputError  where a recording lacks one.
void choose_channels(const std::vector<std::string>& names, std::vector<Recording>& recordings);

/// Warnings of the reader, as attributes of each recording that does not have them yet. A
/// universal file has no place for them.
void add_warning_attributes(const std::vector<Warning>& warnings,
                            std::vector<Recording>& recordings);

/// Recordings, and mode shapes of a universal file; not of standard input, which may be a pipe that
/// can be read only once.
/// @throws Error  as read_recordings().
[[nodiscard]] UffContents read_with_mode_shapes(const std::string& path,
                                                const RecordingReadOptions& options);

}  // namespace microslip
