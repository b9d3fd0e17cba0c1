// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/workflow/compare/tests_verification.hpp"

/// @file
/// Compared tests as a table, and in words.

namespace microslip {

class CsvTable;

// Keys of comments, see comment_entry.hpp.
inline constexpr std::string_view kConfidenceKey = "confidence";  ///< of the bands, 1
inline constexpr std::string_view kNoteKey = "note";  ///< of a test: how its columns were taken
// Of a curve_subject().
inline constexpr std::string_view kInsideKey = "inside";         ///< its values in the band
inline constexpr std::string_view kComparedKey = "compared";     ///< of how many values
inline constexpr std::string_view kPValueKey = "p_value";        ///< p-value of that, 1
inline constexpr std::string_view kFewInsideKey = "few_inside";  ///< there where they are too few

/// Returns the subject of the entries of a curve: "SOURCE: QUANTITY", as the columns have them.
[[nodiscard]] std::string curve_subject(const ComparedTest& test, const ComparedCurve& curve);

/// Text of the table, one row per value: `source, kind, part, quantity, unit, axis, at, measured,
/// measured_std, predicted, lower, upper, verdict`, in SI. Cells are empty where there is no value;
/// `verdict` is `inside` or `outside` of the band, `not_found` where a value that was measured is
/// not predicted, and empty where there is no band or nothing was measured. Its comments give call
/// and inputs, as entries the draws (`draws`, `draws_failed`, `failure`), `confidence`, of each
/// test `note` and `failure`, of each curve `inside`, `compared`, `p_value` and, where the warning
/// of that name is of it, `few_inside`, and all warnings.
[[nodiscard]] std::string comparison_table(const VerifiedTests& verified);

/// Reads such a table back, without its comments.
/// @throws FormatError  where a column is missing, or a cell is wrong.
[[nodiscard]] std::vector<ComparedTest> compared_tests(const CsvTable& table);

/// The summary.
[[nodiscard]] std::string describe_tests(const VerifiedTests& verified);

}  // namespace microslip
