// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "microslip/io/record.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// joint.json, schema microslip.joint/1: a joint, how it came to be, and what its identification
/// knows.

namespace microslip {

struct JointFile {
  Joint joint;
  std::optional<Provenance> provenance;
  Record identification;  ///< range covered, remainder, bands…; empty where the file has none
};

/// @throws FormatError  for text that is no JSON, another schema, keys unknown or missing.
/// @throws InputError   naming `file: density[i].key` for a value of a wrong type or one that
///                      breaks a rule of SlipDensity or Joint.
[[nodiscard]] JointFile parse_joint(std::string_view text, std::string_view file);

/// parse_joint() of a file; "-" is standard input. @throws FileError, FormatError, InputError
[[nodiscard]] JointFile read_joint(const std::string& path);

/// The text that parse_joint() reads back as the same: numbers are the shortest that read back as
/// the same double, keys come in a fixed order, nothing depends on the clock or the locale.
/// @throws InputError  where a value of the records is not finite or no JSON.
[[nodiscard]] std::string format_joint(const JointFile& file);

}  // namespace microslip
