// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/io/bytes/byte_order.hpp"
#include "microslip/io/mat/mat_stream.hpp"

/// @file
/// Numbers as MAT files store them.

namespace microslip {

/// Appends `count` values of type From, converted to To. Doubles go straight to their place.
template <class From, class To>
void read_values(MatStream& stream, std::size_t count, bool swap, std::vector<To>& values) {
  const std::size_t before = values.size();
  values.resize(before + count);
  To* to = values.data() + before;
  if constexpr (std::same_as<From, To>) {
    stream.read(reinterpret_cast<char*>(to), count * sizeof(To));
    if (swap) std::transform(to, to + count, to, byte_swapped<To>);
  } else {
    std::array<From, 4096> buffer;
    for (std::size_t done = 0; done < count;) {
      const std::size_t n = std::min(buffer.size(), count - done);
      stream.read(reinterpret_cast<char*>(buffer.data()), n * sizeof(From));
      for (std::size_t i = 0; i < n; ++i) {
        to[done + i] = static_cast<To>(swap ? byte_swapped(buffer[i]) : buffer[i]);
      }
      done += n;
    }
  }
}

/// One value.
template <class T>
[[nodiscard]] T read_value(MatStream& stream, bool swap) {
  T value;
  stream.read(reinterpret_cast<char*>(&value), sizeof(T));
  return swap ? byte_swapped(value) : value;
}

}  // namespace microslip
