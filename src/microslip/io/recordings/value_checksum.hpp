// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

/// @file
/// The checksum of values in files whose format has none for them.

namespace microslip {

/// A checksum of 64 bits over numbers of 64 bits, w_i, in their order:
///   h_0 = 14695981039346656037,
///   g = (h_i xor w_i)·1099511628211 mod 2⁶⁴,  h_{i+1} = g xor ⌊g/2³²⌋.
/// Each step can be undone, so that a change of one number is always found. It is FNV-1a
/// [http://www.isthe.com/chongo/tech/comp/fnv] over numbers in place of bytes, with one more xor.
/// @param imaginary  follow the values; empty where they are real.
/// @return 16 hexadecimal digits.
[[nodiscard]] std::string checksum_of(std::span<const double> values,
                                      std::span<const double> imaginary = {});

}  // namespace microslip
