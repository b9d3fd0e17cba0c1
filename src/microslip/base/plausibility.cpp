// SPDX-License-Identifier: MIT
#include "microslip/base/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace microslip {
namespace {

struct Bound {
  Dimension dimension;
  double largest;
  std::string_view quantity;
};

constexpr std::array kBounds{
    Bound{kLength, kLargestDisplacement, "displacement"},
    Bound{kVelocity, kLargestVelocity, "velocity"},
    Bound{kAcceleration, kLargestAcceleration, "acceleration"},
    Bound{kEnergy, kLargestDissipation, "loss per cycle"},
};

}  // namespace

std::optional<Warning> implausible_value(std::string_view what, const Dimension& dimension,
                                         double amplitude) {
  const auto* bound = std::ranges::find(kBounds, dimension, &Bound::dimension);
  if (bound == kBounds.end() || !(amplitude > bound->largest)) return std::nullopt;
  return Warning{"implausible_value",
                 fmt::format("{}: {} of {:.3g} {}; no structure survives more than {:.3g} {}. Is "
                             "the unit wrong?",
                             what, bound->quantity, amplitude, si_unit(dimension), bound->largest,
                             si_unit(dimension))};
}

void warn_of_implausible(std::string_view what, const Dimension& dimension,
                         std::span<const double> amplitudes, std::vector<Warning>& warnings) {
  if (amplitudes.empty()) return;
  auto warning = implausible_value(what, dimension, *std::ranges::max_element(amplitudes));
  if (warning) warnings.push_back(*std::move(warning));
}

}  // namespace microslip
