// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/structure/structural_matrices.hpp"

namespace microslip {

/// The largest relative error of the entries of a matrix by the digits that they were written with,
/// beyond that of a double: 5·10⁻ᵈ of d decimal digits, 2⁻²⁴ of numbers of single precision. A
/// matrix counts as rounded to d digits, 6 to 15, where none of its entries has more, and most of
/// fifty different ones or more have all of them; of whole numbers as of others written in full
/// that is not so. At most 20 000 entries are looked at.
/// @return 0 where the entries show no rounding.
[[nodiscard]] double entry_rounding(const SymmetricEntries& entries);

/// As entry_rounding(), of any number of different entries: of a few, as a uniform mesh has them,
/// three quarters must have all of the digits, and yet they may be exact. Never less than
/// entry_rounding().
[[nodiscard]] double possible_entry_rounding(const SymmetricEntries& entries);

}  // namespace microslip
