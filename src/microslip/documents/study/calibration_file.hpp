// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "microslip/io/config/named_values.hpp"

/// @file
/// calibration.json, schema microslip.calibration/1: results of calibrate() that belong to no
/// single level or slip force.

namespace microslip {

/// Contents of a calibration.json.
struct CalibrationFile {
  std::optional<Provenance> provenance = {};  ///< how it came to be
  NamedValues calibration = {};               ///< the results
};

/// @param text  of the file. @param file  its name, for messages.
/// @throws FormatError  where it is no JSON, of another schema, or lacks `calibration`.
[[nodiscard]] CalibrationFile parse_calibration(std::string_view text, std::string_view file);

/// The text of a file that parse_calibration() reads back.
/// @throws InputError  where a number is not finite.
[[nodiscard]] std::string format_calibration(const CalibrationFile& file);

}  // namespace microslip
