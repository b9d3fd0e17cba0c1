// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace microslip {

/// The number of independent draws that determine a mean as well as correlated draws: n/(1 +
/// 2Σρ_k), where the sum of correlations ρ_k of draws k apart ends before the first pair of them
/// that is not positive [Geyer].
/// @param draws  of chains one behind the other.
/// @param chain  draws of each chain; the last may have fewer.
/// @return  from 0 to their number, which is the result for equal draws.
[[nodiscard]] double effective_draws(std::span<const double> draws, std::size_t chain);

}  // namespace microslip
