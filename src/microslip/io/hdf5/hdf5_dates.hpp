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

/// Whole numbers of eight bytes; those without a sign have the bits of the numbers here.
struct WholeNumbers {
  std::vector<std::int64_t> bits;
  bool is_signed = true;
};

/// Whole numbers without a unit that count from 1970 (counted_unit()) are given from the first on,
/// as are those from 2⁶³ on or whose steps doubles do not hold to 1e-6; others are as they are.
/// @param unit   as in the file; empty: none.
/// @param place  of the numbers, for the warning.
[[nodiscard]] WholeTimes whole_times(const WholeNumbers& whole, const std::string& unit,
                                     const std::string& place);

/// Whether a type is one of whole numbers of eight bytes.
[[nodiscard]] bool is_large_integer(hid_t type);

/// The type in memory that holds them all, with a sign or without one.
[[nodiscard]] hid_t large_integer_in_memory(hid_t type);

/// A type of times that HDF5 has and PyTables writes: whole seconds since 1970 in 32 bits, or in 64
/// bits pairs of seconds (the upper half) and microseconds. HDF5 does not convert them.
struct Hdf5Time {
  hid_t type;
  bool is_pair;
  bool is_big;  ///< big-endian
};
/// Nothing where a type is another.
[[nodiscard]] std::optional<Hdf5Time> hdf5_time(hid_t type);

/// A time by its bits as they are stored, the first of which are those of whole seconds in 32 bits.
[[nodiscard]] std::int64_t time_in_nanoseconds(std::int64_t bits, const Hdf5Time& time);

/// Seconds from the first of dates on: doubles do not hold dates.
[[nodiscard]] std::vector<double> seconds_from_first(std::span<const std::int64_t> nanoseconds);

/// The difference of two dates, which may be any numbers.
[[nodiscard]] std::int64_t difference(std::int64_t later, std::int64_t earlier);

}  // namespace microslip
