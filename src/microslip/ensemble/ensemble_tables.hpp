// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"
#include "microslip/io/output/output_files.hpp"

namespace microslip {

/// Adds the table of a result as CSV to the files to be written. Of a sweep one row per point of
/// the grid and output, `value` among them; of all else one row per value of an output, with its
/// statistics over the jobs. The column `unit` gives the unit of all numbers of a row except those
/// of an axis. Rows go to the disk in blocks: memory does not grow with their number, but on
/// standard output.
/// @param result    to be written.
/// @param rows_of   of the jobs of a group.
/// @param command   that the file is made by.
/// @param path      of the table; "-" is standard output.
/// @param outputs   that it is added to.
/// @throws FileError  as OutputFiles.
void add_ensemble_table(const EnsembleResult& result,
                        const std::function<RowPass(std::size_t group)>& rows_of,
                        const std::string& command, const std::string& path, OutputFiles& outputs);

/// Warnings of a result: jobs that failed, values that few jobs have, quantiles beyond which no job
/// lies.
[[nodiscard]] std::vector<Warning> ensemble_warnings(const EnsembleResult& result);

}  // namespace microslip
