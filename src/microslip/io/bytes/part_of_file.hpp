// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// @file
/// A file, or a variable in it, by one name.

namespace microslip {

/// `FILE:VARIABLE`, a part of a file, where there is no file of the whole name; or the file alone.
struct PartOfFile {
  std::string file;      ///< of the file alone
  std::string variable;  ///< empty for the whole file
};
/// Takes such a name apart, at the last colon before which there is a file.
[[nodiscard]] PartOfFile part_of_file(const std::string& path);

}  // namespace microslip
