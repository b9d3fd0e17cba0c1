// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/value_checksum.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace microslip {
namespace {

std::uint64_t checksum_after(std::uint64_t state, std::span<const double> values) {
  constexpr std::uint64_t kPrime = 1099511628211U;
  constexpr unsigned kHalf = 32;
  for (const double value : values) {
    const std::uint64_t product = (state ^ std::bit_cast<std::uint64_t>(value)) * kPrime;
    state = product ^ (product >> kHalf);
  }
  return state;
}

}  // namespace

std::string checksum_of(std::span<const double> values, std::span<const double> imaginary) {
  constexpr std::uint64_t kBegin = 14695981039346656037U;
  return fmt::format("{:016x}", checksum_after(checksum_after(kBegin, values), imaginary));
}

}  // namespace microslip
