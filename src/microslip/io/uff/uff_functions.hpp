// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/io/recordings/recordings.hpp"
#include "microslip/io/uff/uff58_header.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Recordings as datasets 58 that others read or write. Not installed.

namespace microslip {

/// Recordings of functions as a universal file has them, as read_recordings_uff() reads one without
/// dataset 164: functions that follow each other over one axis are a recording.
/// @param functions  one at least, in the order of the file.
/// @param source     of the recordings; with a number behind it where they are several.
/// @throws InputError  as check_recording().
[[nodiscard]] Recordings recordings_of_functions(std::vector<Uff58> functions,
                                                 const std::string& source);

/// The functions of a recording that write_recordings_uff() writes to a binary file, one per
/// channel.
/// @throws InputError  as check_recording(); where the label of a unit has no place.
[[nodiscard]] std::vector<Uff58> functions_of_recording(const Recording& recording);

}  // namespace microslip
