// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
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

/// Whole numbers without a unit that count from 1970 (counted_unit()) are given from the first on,
/// as are those whose steps doubles do not hold to 1e-6; others are as they are.
/// @param unit   as in the file; empty: none.
/// @param place  of the numbers, for the warning.
[[nodiscard]] WholeTimes whole_times(std::span<const std::int64_t> numbers, const std::string& unit,
                                     const std::string& place);

/// Whether a type is one of whole numbers of eight bytes.
[[nodiscard]] bool is_large_integer(hid_t type);

/// The difference of two dates, which may be any numbers.
[[nodiscard]] std::int64_t difference(std::int64_t later, std::int64_t earlier);

}  // namespace microslip
