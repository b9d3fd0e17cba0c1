// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/workflow/compare/tests_verification.hpp"

/// @file
/// Compared tests as a table, and in words.

namespace microslip {

class CsvTable;

/// Text of the table, one row per value: `source, kind, part, quantity, unit, axis, at, measured,
/// measured_std, predicted, lower, upper, verdict`, in SI. Cells are empty where there is no value;
/// `verdict` is `inside` or `outside` of the band, `not_found` where a value that was measured is
/// not predicted, and empty where there is no band or nothing was measured. Its comments tell call
/// and inputs, the draws, of each test how its columns were taken, how many values lie inside and
/// how many were expected, and all warnings.
[[nodiscard]] std::string comparison_table(const VerifiedTests& verified);

/// Reads such a table back, without its comments: what became of draws, and warnings.
/// @throws FormatError  where a column is missing, or a cell is wrong.
[[nodiscard]] std::vector<ComparedTest> compared_tests(const CsvTable& table);

/// The summary.
[[nodiscard]] std::string describe_tests(const VerifiedTests& verified);

}  // namespace microslip
