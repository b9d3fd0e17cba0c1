// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/config/named_values.hpp"

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

/// The comment that names an input: `sha256[FILE] = …`, see comment_entry.hpp.
[[nodiscard]] std::string hash_comment(std::string_view file, std::string_view sha256);

/// Returns the inputs that comments name so, in their order, or as "FILE: sha256 …", which earlier
/// versions wrote.
[[nodiscard]] std::vector<InputHash> hashes_in(std::span<const std::string> comments);

/// The lines of a comment: heading_of(), then hash_comment() of each input.
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
