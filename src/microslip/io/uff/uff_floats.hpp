// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// @file
/// The floating-point numbers of binary datasets. Internal to io.

namespace microslip {

/// How a real number is stored.
enum class UffFloat {
  kIeee4Little,
  kIeee4Big,
  kIeee8Little,
  kIeee8Big,
};

/// By the codes of the header of 58b.
/// @param byte_order  1 little-endian, 2 big-endian.
/// @param format      1 DEC VMS, 2 IEEE 754, 3 IBM System/370 (base 16).
/// @param size        4 or 8 bytes.
/// @return  nothing for what is not IEEE 754: no file of the last decades has another.
[[nodiscard]] std::optional<UffFloat> uff_float(long long byte_order, long long format,
                                                std::size_t size);

/// Every stride-th number from `bytes` on.
/// @param stride  bytes from one to the next.
void decode_uff_floats(UffFloat format, const char* bytes, std::size_t stride,
                       std::span<double> numbers);

}  // namespace microslip
