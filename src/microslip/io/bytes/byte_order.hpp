// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstring>

namespace microslip {

/// The bytes of a T in the other order.
template <class T>
[[nodiscard]] T byte_swapped(T value) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(T));
  std::ranges::reverse(bytes);
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

}  // namespace microslip
