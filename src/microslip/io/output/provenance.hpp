// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/cells/csv_writer.hpp"

/// @file
/// Provenance and warnings in files that are written.

namespace microslip {

/// An input, as it was named and read.
struct NamedInput {
  std::string path;  ///< "-" is standard input
  std::string text;  ///< all of it
};

/// The first comment of a file: "microslip VERSION: COMMAND".
[[nodiscard]] std::string heading_of(std::string_view command);

/// The lines of a comment: heading_of(), then "FILE: sha256 …" of each input.
[[nodiscard]] std::string provenance_of(std::string_view command,
                                        const std::vector<NamedInput>& inputs);

/// Lines of a comment, "warning: CODE: TEXT" each: warnings printed, or with --quiet not printed,
/// are in the file too. Empty without warnings.
[[nodiscard]] std::string warning_lines(const std::vector<Warning>& warnings);

/// The same behind the lines of another comment.
[[nodiscard]] std::string with_warnings(std::string comment, const std::vector<Warning>& warnings);

/// The same as comments of a table.
void add_warnings(const std::vector<Warning>& warnings, CsvWriter& table);

}  // namespace microslip
