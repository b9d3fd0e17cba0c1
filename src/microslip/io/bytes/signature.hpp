// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// Kind of a file by its first bytes: "a PNG picture", "a MATLAB file", "an HDF5 file", "JSON",
/// "a TDMS file of LabVIEW", …, and those of laboratories that are not read: "an MDF file (ASAM)";
/// empty where they are those of no format known here, as with tables.
[[nodiscard]] std::string_view signature(std::string_view head);

/// Of a ZIP archive whose files no reader knows.
inline constexpr std::string_view kZipSignature = "a ZIP archive or a spreadsheet";

/// Whether the readers of MAT files take a file of this signature: MATLAB's, and Octave's text.
[[nodiscard]] bool is_mat_signature(std::string_view signature);

/// Remedy for a file of this signature where another is expected: the way out of a format that is
/// not read.
[[nodiscard]] std::string_view remedy_for_signature(std::string_view signature);

}  // namespace microslip
