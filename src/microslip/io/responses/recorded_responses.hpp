// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>

#include "microslip/base/units.hpp"
#include "microslip/io/responses/uff_responses.hpp"
#include "microslip/io/uff/uff58_header.hpp"

/// @file
/// Frequency responses from recordings in CSV, MATLAB and HDF5 files. Internal to io.

namespace microslip {

/// Where a channel belongs, for a file that does not tell it.
struct ResponseChannel {
  std::string name;               ///< of the channel
  UffPoint response;              ///< with the sign of the direction
  UffPoint reference = {};        ///< of the force
  std::optional<Unit> unit = {};  ///< of a channel that has none in the file
};

/// The channels of the list, or, without one, those that have the attributes of a frequency
/// response of a universal file ("function type", "response node", …), as `convert` keeps them.
/// Channels of other kinds are skipped, and lines at 0 Hz.
/// @param path      of the file; `FILE:VARIABLE` for a part of a MATLAB file.
/// @param channels  in any order; may be empty.
/// @throws FormatError, FileError  as read_recordings(); where no frequency response is found.
/// @throws InputError  naming the channel, as read_responses_uff(); where it is missing or there
///                     twice, or has a unit beside the one given.
[[nodiscard]] FrequencyResponses read_recorded_responses(const std::string& path,
                                                         std::span<const ResponseChannel> channels);

}  // namespace microslip
