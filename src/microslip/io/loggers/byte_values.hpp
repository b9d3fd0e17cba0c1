// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>

#include "microslip/io/bytes/byte_order.hpp"

/// @file
/// Numbers out of the bytes of a file. Internal to io/loggers.

namespace microslip {

/// The value that begins at `from`, of a file whose byte order is that of this machine or not.
template <class T>
[[nodiscard]] T value_of_bytes(const char* from, bool swap) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return swap ? byte_swapped(value) : value;
}

/// Converts `count` values, `stride` bytes apart, to doubles.
using ConvertBytes = void (*)(const char* from, std::size_t stride, std::size_t count, double* to);

template <class T, bool Swap>
void convert_bytes(const char* from, std::size_t stride, std::size_t count, double* to) {
  if (stride == sizeof(T)) {  // known when compiled, so that whole vectors are converted
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = static_cast<double>(value_of_bytes<T>(from + i * sizeof(T), Swap));
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = static_cast<double>(value_of_bytes<T>(from + i * stride, Swap));
  }
}

template <class T>
[[nodiscard]] ConvertBytes converter(bool swap) {
  return swap ? convert_bytes<T, true> : convert_bytes<T, false>;
}

}  // namespace microslip
