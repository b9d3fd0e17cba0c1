// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/tables/csv.hpp"

/// @file
/// Tables whose values check themselves. Internal to documents.

namespace microslip {

/// Returns what `read` takes from the table of a file, "-" for standard input, after its check(),
/// whose errors name the file.
/// @throws FileError, FormatError  as CsvTable. @throws InputError  as check().
template <typename Read>
[[nodiscard]] auto read_checked_table(const std::string& path, const Read& read) {
  const CsvTable table(read_text(path), input_name(path));
  auto values = read(table);
  try {
    values.check();
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", table.file(), error.name()));
  }
  return values;
}

}  // namespace microslip
