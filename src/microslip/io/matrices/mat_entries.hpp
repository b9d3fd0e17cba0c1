// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/io/matrices/symmetric_entries.hpp"

namespace microslip {

/// A square real matrix, full or sparse, of a file that read_mat_tree() takes. Internal to io.
/// @param variable  as in mat_value.hpp, with / as good as a dot; empty: the only matrix of the
///     file.
/// @throws FileError, FormatError  as read_mat_tree(). @throws InputError  where it is missing, one
///                                 of several, not square, complex or not finite.
[[nodiscard]] MatrixEntries read_mat_entries(const std::string& path, std::string_view variable);

}  // namespace microslip
