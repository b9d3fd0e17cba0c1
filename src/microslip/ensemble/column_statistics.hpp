// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/documents/study/ensemble_result_file.hpp"

namespace microslip {

/// The statistics of each column of a table that is too large to be kept: quantiles are exact, by
/// selection in passes over the rows. The order statistics are found digit by digit in the order of
/// doubles, 11 bits per pass; memory does not grow with the number of rows.
/// @param pass        gives the rows, each with `columns` values.
/// @param columns     of the table.
/// @param confidence  P, in (0, 1).
[[nodiscard]] std::vector<ColumnStatistics> column_statistics(const RowPass& pass,
                                                              std::size_t columns,
                                                              double confidence);

}  // namespace microslip
