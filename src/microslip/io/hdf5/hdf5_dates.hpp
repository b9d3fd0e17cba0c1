// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "microslip/io/recordings/whole_times.hpp"

/// @file
/// Types of HDF5 with times in whole numbers (whole_times.hpp).

namespace microslip {

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

}  // namespace microslip
