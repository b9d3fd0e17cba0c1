// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Matrices in the exchange format of Harwell and Boeing, as of `HBMAT` of Ansys and of many
/// solvers: four lines of header, then pointers, rows and values of compressed columns in
/// fields of fixed width (Duff, Grimes, Lewis: Users' Guide for the Harwell–Boeing Sparse Matrix
/// Collection, 1992). Internal to io.

namespace microslip {

/// @param head  the first bytes of a file, 400 of them or all.
[[nodiscard]] bool is_harwell_boeing(std::string_view head);

/// A real assembled matrix, symmetric (one triangle) or not said to be (both). Right-hand sides
/// behind it are not looked at.
/// @param file  its name, for messages.
/// @throws FormatError  with line and column. @throws InputError  where it is not symmetric.
[[nodiscard]] SymmetricEntries parse_harwell_boeing(std::string_view text, std::string_view file);

/// parse_harwell_boeing() of a file. @throws FileError
[[nodiscard]] SymmetricEntries read_harwell_boeing(const std::string& path);

}  // namespace microslip
