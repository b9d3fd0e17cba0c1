// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip {

/// Whether this program wrote a file, by the mark that each of its files bears: the comment
/// "# microslip VERSION: CALL" above a table or in a TOML file, the provenance of a JSON file, the
/// schema of an HDF5 file, the program named by a universal file, a MATLAB file, a picture or a
/// report. A file that a person wrote by the description of its format bears none.
/// @param content  of the file; all of it, for some marks stand at its end.
[[nodiscard]] bool has_own_mark(std::string_view content);

/// has_own_mark() of a file. @throws FileError  where it cannot be read.
[[nodiscard]] bool is_own_file(const std::string& path);

/// Whether two files hold the same bytes. @throws FileError  where one cannot be read.
[[nodiscard]] bool has_same_bytes(const std::string& a, const std::string& b);

}  // namespace microslip
