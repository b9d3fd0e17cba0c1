// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"

/// @file
/// Times in whole numbers, which doubles do not hold where they count from 1970.

namespace microslip {

/// Times from the first on.
struct WholeTimes {
  std::vector<double> values;
  std::string unit;                     ///< as in the file, or found by their size
  std::optional<Warning> warning = {};  ///< where it was found so
};

/// Whole numbers of eight bytes; those without a sign have the bits of the numbers here.
struct WholeNumbers {
  std::vector<std::int64_t> bits = {};
  bool is_signed = true;
};

/// The numbers where doubles do not hold one of them, as it is beyond 2^53; none where they do.
[[nodiscard]] WholeNumbers beyond_doubles(WholeNumbers numbers);

/// Whole numbers without a unit that count from 1970 (counted_unit()) are given from the first on,
/// as are those from 2⁶³ on or whose steps doubles do not hold to 1e-6; others are as they are.
/// @param unit   as in the file; empty: none.
/// @param place  of the numbers, for the warning.
[[nodiscard]] WholeTimes whole_times(const WholeNumbers& whole, const std::string& unit,
                                     const std::string& place);

/// The difference of two dates, which may be any numbers.
[[nodiscard]] std::int64_t difference(std::int64_t later, std::int64_t earlier);

}  // namespace microslip
