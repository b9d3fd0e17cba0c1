// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

/// @file
/// Names in the HDF5 files that microslip writes, see hdf5_recording.hpp.

namespace microslip {

inline constexpr std::string_view kRecordingSchema = "microslip.recording/1";

/// Attributes of a recording and of a channel that are not its `attributes`.
inline constexpr std::array kRecordingKeys{"source", "axis_unit", "start", "step", "fs"};
/// Of a dataset, checksum_of() its values.
inline constexpr const char* kChecksumKey = "microslip_checksum";
inline constexpr std::array kChannelKeys{"channel_name", "unit_str", "quantity", "fs",
                                         kChecksumKey};

}  // namespace microslip
