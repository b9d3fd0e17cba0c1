// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "microslip/base/units.hpp"
#include "microslip/documents/structure/tested_structure.hpp"
#include "microslip/io/config/toml_input.hpp"

/// @file
/// The table [test] of a STRUCTURE.toml. Internal to documents.

namespace microslip {

/// @param test  the table; its file is read, too. @param file  that it is in.
/// @throws FormatError, InputError, FileError  naming the key, or the dataset of the file.
[[nodiscard]] TestedStructure read_tested_structure(const TomlTable& test, std::string_view file);

/// The unit of a key in SI; 1 without the key.
[[nodiscard]] double read_unit_factor(const TomlTable& table, std::string_view key,
                                      const Dimension& dimension);

}  // namespace microslip
