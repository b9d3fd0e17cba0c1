// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "microslip/io/tables/csv.hpp"

/// @file
/// Rules on the numbers of a column. @throws FormatError  at the first cell that breaks the rule.

namespace microslip {

/// Of an amplitude that is not above 0.
inline constexpr std::string_view kRemedyForNoMotion =
    "A level without motion has no information: remove the row. Logarithms are not taken.";

/// Each value above 0.
void require_positive(const CsvTable& table, std::string_view name, std::span<const double> values,
                      std::string_view remedy = {});

/// Each value 0 or above.
void require_non_negative(const CsvTable& table, std::string_view name,
                          std::span<const double> values, std::string_view remedy = {});

/// Each value at least that of the row before it.
void require_rising(const CsvTable& table, std::string_view name, std::span<const double> values,
                    std::string_view remedy = {});

}  // namespace microslip
