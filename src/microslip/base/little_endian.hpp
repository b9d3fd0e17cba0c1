// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// @file
/// Whole numbers as eight bytes, the lowest first, whatever the machine.

namespace microslip {

inline constexpr std::size_t kLittleEndianSize = 8;  ///< bytes

/// Appends a number to bytes.
inline void append_little_endian(std::string& bytes, std::uint64_t value) {
  for (std::size_t i = 0; i < kLittleEndianSize; ++i) {
    bytes += static_cast<char>(value >> (8U * i) & 0xFFU);
  }
}

/// The number that bytes begin with. @param bytes  eight or more.
[[nodiscard]] inline std::uint64_t from_little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = kLittleEndianSize; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

}  // namespace microslip
