// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "microslip/io/config/named_values.hpp"

/// @file
/// calibration.json, schema microslip.calibration/1: what calibrate() found that belongs to no
/// single level and no single slip force.

namespace microslip {

/// What a calibration.json holds.
struct CalibrationFile {
  std::optional<Provenance> provenance = {};  ///< how it came to be
  NamedValues calibration = {};               ///< what was found
};

/// @param text  of the file. @param file  its name, for messages.
/// @throws FormatError  where it is no JSON, of another schema, or lacks `calibration`.
[[nodiscard]] CalibrationFile parse_calibration(std::string_view text, std::string_view file);

/// The text of a file that parse_calibration() reads back.
/// @throws InputError  where a number is not finite.
[[nodiscard]] std::string format_calibration(const CalibrationFile& file);

}  // namespace microslip
