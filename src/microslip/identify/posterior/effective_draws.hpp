// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace microslip {

/// How many independent draws know a mean as well as draws of which neighbours are alike:
/// n/(1 + 2Σρ_k), where the sum of correlations ρ_k of draws k apart ends before the first pair of
/// them that is not positive [Geyer].
/// @param draws  of chains one behind the other.
/// @param chain  draws of each chain; the last may have fewer.
/// @return  from 0 to their number, which draws that are all equal give.
[[nodiscard]] double effective_draws(std::span<const double> draws, std::size_t chain);

}  // namespace microslip
