// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "microslip/io/cells/csv_column.hpp"

namespace microslip {

/// What stands between the name of a column and its unit where there are no brackets: `F/kN` and
/// `F / kN` (ISO 80000-1), `Force, kN`, `F in kN`, `force_kN`.
enum class UnitMark { kSlash, kComma, kWord, kUnderscore };

/// Name and unit of a column by a mark. Of a name with several marks the longest unit is taken:
/// `v/m/s` is v in m/s, `k_N_per_m` k in N/m. With kUnderscore, which may be part of any name, the
/// whole stays the name. Nothing where no known unit stands behind a mark.
[[nodiscard]] std::optional<CsvColumn> split_unit_of_name(std::string_view name, UnitMark mark);

/// The mark by which the columns of a table have their units: that of a column without a unit of
/// its own which is called a time or frequency and has a unit of it. Nothing where there is none.
[[nodiscard]] std::optional<UnitMark> unit_mark_of(std::span<const CsvColumn> columns);

}  // namespace microslip
