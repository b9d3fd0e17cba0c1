// SPDX-License-Identifier: MIT
#include "microslip/io/uff_floats.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace microslip {
namespace {

std::uint32_t swapped(std::uint32_t bits) { return __builtin_bswap32(bits); }
std::uint64_t swapped(std::uint64_t bits) { return __builtin_bswap64(bits); }

template <class Bits, std::endian kOrder>
Bits load(const char* bytes) {
  Bits bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return kOrder == std::endian::native ? bits : swapped(bits);
}

struct Ieee {
  static double decode(std::uint32_t bits) { return std::bit_cast<float>(bits); }
  static double decode(std::uint64_t bits) { return std::bit_cast<double>(bits); }
};

/// (-1)^s · 0.f · 16^(e-64): sign 1 bit, exponent e 7 bits, fraction f 24 or 56 bits.
struct Ibm {
  template <class Bits>
  static double decode(Bits bits) {
    constexpr int kWidth = 8 * static_cast<int>(sizeof(Bits));
    constexpr int kFraction = kWidth - 8;
    const Bits fraction = bits & ((Bits{1} << kFraction) - 1);
    const int exponent = static_cast<int>((bits >> kFraction) & 0x7FU) - 64;
    const double size = std::ldexp(static_cast<double>(fraction), 4 * exponent - kFraction);
    return (bits >> (kWidth - 1)) != 0 ? -size : size;
  }
};

/// (-1)^s · 0.1f · 2^(e-128): sign, exponent e 8 bits, fraction f 23 bits behind a hidden one, the
/// more significant word first. e = 0 is 0, or with a sign the reserved operand, no number.
struct VaxF {
  static double decode(std::uint32_t bits) {
    bits = (bits << 16U) | (bits >> 16U);
    const int exponent = static_cast<int>((bits >> 23U) & 0xFFU);
    const bool negative = (bits >> 31U) != 0;
    if (exponent == 0) return negative ? std::nan("") : 0.0;
    const auto fraction = static_cast<double>((bits & 0x7FFFFFU) | 0x800000U);
    const double size = std::ldexp(fraction, exponent - 128 - 24);
    return negative ? -size : size;
  }
};

template <class Format, class Bits, std::endian kOrder>
void decode_as(const char* bytes, std::size_t stride, std::span<double> numbers) {
  for (double& number : numbers) {
    number = Format::decode(load<Bits, kOrder>(bytes));
    bytes += stride;
  }
}

}  // namespace

std::optional<UffFloat> uff_float(long long byte_order, long long format, std::size_t size) {
  if (byte_order != 1 && byte_order != 2) return std::nullopt;
  const bool little = byte_order == 1;
  const bool single = size == 4;
  if (format == 1 && single && little) return UffFloat::kVaxF;
  if (format == 2 && single) return little ? UffFloat::kIeee4Little : UffFloat::kIeee4Big;
  if (format == 2) return little ? UffFloat::kIeee8Little : UffFloat::kIeee8Big;
  if (format == 3 && single) return little ? UffFloat::kIbm4Little : UffFloat::kIbm4Big;
  if (format == 3) return little ? UffFloat::kIbm8Little : UffFloat::kIbm8Big;
  return std::nullopt;
}

void decode_uff_floats(UffFloat format, const char* bytes, std::size_t stride,
                       std::span<double> numbers) {
  using std::endian;
  switch (format) {
    case UffFloat::kIeee4Little:
      return decode_as<Ieee, std::uint32_t, endian::little>(bytes, stride, numbers);
    case UffFloat::kIeee4Big:
      return decode_as<Ieee, std::uint32_t, endian::big>(bytes, stride, numbers);
    case UffFloat::kIeee8Little:
      return decode_as<Ieee, std::uint64_t, endian::little>(bytes, stride, numbers);
    case UffFloat::kIeee8Big:
      return decode_as<Ieee, std::uint64_t, endian::big>(bytes, stride, numbers);
    case UffFloat::kIbm4Little:
      return decode_as<Ibm, std::uint32_t, endian::little>(bytes, stride, numbers);
    case UffFloat::kIbm4Big:
      return decode_as<Ibm, std::uint32_t, endian::big>(bytes, stride, numbers);
    case UffFloat::kIbm8Little:
      return decode_as<Ibm, std::uint64_t, endian::little>(bytes, stride, numbers);
    case UffFloat::kIbm8Big:
      return decode_as<Ibm, std::uint64_t, endian::big>(bytes, stride, numbers);
    case UffFloat::kVaxF:
      return decode_as<VaxF, std::uint32_t, endian::little>(bytes, stride, numbers);
  }
}

}  // namespace microslip
