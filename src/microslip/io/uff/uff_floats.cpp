// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_floats.hpp"

#include <bit>
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

double ieee(std::uint32_t bits) { return std::bit_cast<float>(bits); }
double ieee(std::uint64_t bits) { return std::bit_cast<double>(bits); }

template <class Bits, std::endian kOrder>
void decode_as(const char* bytes, std::size_t stride, std::span<double> numbers) {
  for (double& number : numbers) {
    number = ieee(load<Bits, kOrder>(bytes));
    bytes += stride;
  }
}

}  // namespace

std::optional<UffFloat> uff_float(long long byte_order, long long format, std::size_t size) {
  if (format != 2 || (byte_order != 1 && byte_order != 2)) return std::nullopt;
  const bool little = byte_order == 1;
  const bool single = size == 4;
  if (single) return little ? UffFloat::kIeee4Little : UffFloat::kIeee4Big;
  return little ? UffFloat::kIeee8Little : UffFloat::kIeee8Big;
}

void decode_uff_floats(UffFloat format, const char* bytes, std::size_t stride,
                       std::span<double> numbers) {
  using std::endian;
  switch (format) {
    case UffFloat::kIeee4Little:
      return decode_as<std::uint32_t, endian::little>(bytes, stride, numbers);
    case UffFloat::kIeee4Big:
      return decode_as<std::uint32_t, endian::big>(bytes, stride, numbers);
    case UffFloat::kIeee8Little:
      return decode_as<std::uint64_t, endian::little>(bytes, stride, numbers);
    case UffFloat::kIeee8Big:
      return decode_as<std::uint64_t, endian::big>(bytes, stride, numbers);
  }
}

}  // namespace microslip
