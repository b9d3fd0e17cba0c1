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

/// Whether a type is one of times that HDF5 has and PyTables writes: whole seconds since 1970 in 32
/// bits, or in 64 bits pairs of seconds (the upper half) and microseconds. HDF5 does not convert
/// them.
[[nodiscard]] bool is_hdf5_time(hid_t type);
[[nodiscard]] bool is_time_of_pairs(hid_t type);

/// A time of such a type by its bits, of which seconds are the lower half.
[[nodiscard]] std::int64_t time_in_nanoseconds(std::int64_t bits, bool is_pair);

/// Seconds from the first of dates on: doubles do not hold dates.
[[nodiscard]] std::vector<double> seconds_from_first(std::span<const std::int64_t> nanoseconds);

/// The difference of two dates, which may be any numbers.
[[nodiscard]] std::int64_t difference(std::int64_t later, std::int64_t earlier);

}  // namespace microslip
