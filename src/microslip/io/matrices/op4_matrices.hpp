// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/io/matrices/symmetric_entries.hpp"

/// @file
/// Matrices as the module OUTPUT4 of Nastran writes them: text or records of Fortran, of either
/// byte order and of integers of 32 or 64 bits, each column dense or as strings of non-zeros (both
/// forms, BIGMAT or not). Internal to io.

namespace microslip {

/// @param head  the first bytes of a file, 100 of them or all.
[[nodiscard]] bool is_op4(std::string_view head);

/// A square real matrix of a file that may have several. One of the form 6, symmetric, may have one
/// triangle or both; others have the whole matrix.
/// @param name  of the matrix, capitals or not; empty: the only square real one of the file.
/// @param file  for messages.
/// @throws FormatError  where the file is damaged or truncated.
/// @throws InputError   where there is no such matrix, or several; where it is complex, rectangular
///     or not symmetric.
[[nodiscard]] SymmetricEntries parse_op4(std::string_view bytes, std::string_view name,
                                         const std::string& file);

/// parse_op4() of a file. @throws FileError
[[nodiscard]] SymmetricEntries read_op4(const std::string& path, std::string_view name);

}  // namespace microslip
