// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Recorded and predicted signals in tables, for the report.

namespace microslip {

/// Of `source, time [s], <channel>_<recorded> [unit], <channel>_<other> [unit]…`, one entry per
/// source.
/// @throws FormatError  where a column is missing.
[[nodiscard]] std::vector<LevelRecord> histories_of(const CsvTable& table,
                                                    const std::string& recorded,
                                                    const std::string& other);

/// Of `source, harmonic [1], <channel>_<recorded> [unit], <channel>_<other> [unit]…`, with
/// <channel>_<recorded>_std where it is there, added to the
/// entries of the same sources, which are made where they are missing.
/// @throws FormatError  where a column is missing.
void add_harmonics(const CsvTable& table, const std::string& recorded, const std::string& other,
                   std::vector<LevelRecord>& records);

}  // namespace microslip
