// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/structure/structural_matrices.hpp"

/// @file
/// From the entries of a file to a symmetric matrix. Internal to io.

namespace microslip {

/// A square matrix by the entries that a file has, in any order; those of one place add up.
struct MatrixEntries {
  std::size_t size = 0;              ///< rows, and columns
  std::vector<std::int32_t> row;     ///< from 0, < size
  std::vector<std::int32_t> column;  ///< from 0, < size; one an entry
  std::vector<double> value;         ///< one an entry
};

/// Of a file that has the whole matrix: a pair of entries that differ by rounding is its mean.
/// @param file    for messages.
/// @param remedy  where they differ, for messages.
/// @throws InputError  naming the entry that differs from that across the diagonal by more than
///                     1e-8 √(a_ii a_jj).
[[nodiscard]] SymmetricEntries symmetric_of_both(const MatrixEntries& entries,
                                                 std::string_view file, std::string_view remedy);

/// Where a program writes whole lines a text that ends within one may lack digits of its last
/// number. @throws FormatError  where the text does not end with a line. @param place  of its last.
void require_whole_lines(std::string_view text, const TextPlace& place);

/// Whether an entry off the diagonal has one across the diagonal.
[[nodiscard]] bool has_both_triangles(const MatrixEntries& entries);

/// Of a file that has one triangle, the upper or the lower.
/// @throws InputError  naming an entry beside the triangle of the first one that is off the
///     diagonal.
[[nodiscard]] SymmetricEntries symmetric_of_triangle(MatrixEntries entries, std::string_view file);

}  // namespace microslip
