// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace microslip {

/// Whether a joint is known only together with another, or with all others. One that stands alone
/// in `known_in_sum` has none to be known with.
/// @param found  has `pairs` of `first`, `second` and `known_only_together`, and `known_in_sum`.
/// @param joint  as these name it.
template <typename Found, typename Joint>
[[nodiscard]] bool known_only_together(const Found& found, const Joint& joint) {
  const auto holds = [&](const auto& pair) {
    return pair.known_only_together && (pair.first == joint || pair.second == joint);
  };
  return (found.known_in_sum.size() > 1 && std::ranges::count(found.known_in_sum, joint) > 0) ||
         std::ranges::any_of(found.pairs, holds);
}

}  // namespace microslip
