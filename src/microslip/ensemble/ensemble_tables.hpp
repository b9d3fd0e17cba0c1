// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"

namespace microslip {

/// The table of a result as CSV. Of a sweep one row per point of the grid and output, `value` among
/// them; of all else one row per value of an output, with its statistics over the jobs. The column
/// `unit` gives the unit of all numbers of a row except those of an axis.
/// @param result    to be written.
/// @param rows_of   of the jobs of a group.
/// @param command   that the file is made by.
/// @param warnings  of the result.
[[nodiscard]] std::string ensemble_table(const EnsembleResult& result,
                                         const std::function<RowPass(std::size_t group)>& rows_of,
                                         const std::string& command,
                                         const std::vector<Warning>& warnings);

/// Warnings of a result: jobs that failed, values that few jobs have, quantiles beyond which no job
/// lies.
[[nodiscard]] std::vector<Warning> ensemble_warnings(const EnsembleResult& result);

}  // namespace microslip
