// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Matrices in the Matrix Market exchange format (Boisvert, Pozo, Remington 1996, NISTIR 5935).

namespace microslip {

/// A real symmetric matrix: `coordinate` or `array`, `real` or `integer`, `symmetric` (the lower
/// triangle, here the upper as well) or `general` (both).
/// @param text  the file's whole text.
/// @param file  its name, for messages.
/// @throws FormatError  with line and column where the text has another form, claims more entries
///                      than it has room for, or has more or fewer; for an index out of range, with
///                      a word on those that count from 0.
/// @throws InputError   where it is not square or not symmetric, naming the entry.
[[nodiscard]] SymmetricEntries parse_matrix_market(std::string_view text, std::string_view file);

/// parse_matrix_market() of a file. @throws FileError, FormatError, InputError
[[nodiscard]] SymmetricEntries read_matrix_market(const std::string& path);

}  // namespace microslip
