// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "microslip/base/random.hpp"

/// @file
/// Random streams of draws of a structure. Internal to dynamics.

namespace microslip {

/// A kind of number has streams of its own, so that a draw of one does not depend on which others
/// are uncertain. Those of identifications are small numbers.
enum class DrawnKind : std::uint64_t {
  kFrequency = 1,
  kLossFactor,
  kNormalLoad,
  kForceGain,
  kResponseGain,
  kOrder,
  kTurn,
};

/// @param seed of all. @param kind of the number. @param number  of the stream among its kind.
[[nodiscard]] inline RandomStream draw_stream(std::uint64_t seed, DrawnKind kind,
                                              std::uint64_t number) {
  constexpr unsigned kKindBits = 48;
  return {seed, (static_cast<std::uint64_t>(kind) << kKindBits) + number};
}

/// e^{σz} for the next z, which is also drawn where σ is 0.
[[nodiscard]] inline double drawn_factor(RandomStream& random, const std::vector<double>& spread,
                                         std::size_t at) {
  const double z = random.normal();
  return spread.empty() || spread[at] == 0.0 ? 1.0 : std::exp(spread[at] * z);
}

/// @throws InputError  for a σ out of range, or another number of them than `count` or none.
void check_spread(std::string_view name, const std::vector<double>& spread, std::size_t count,
                  std::string_view of);

}  // namespace microslip
