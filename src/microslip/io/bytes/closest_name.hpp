// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace microslip {

/// The candidate that was probably meant by `name`: the one that completes it ("length" of
/// "length_m"), or else the one with the fewest characters inserted, removed, replaced or swapped
/// with their neighbour, if these are at most a third of the name's. Empty where there is none.
[[nodiscard]] std::string_view closest_name(std::string_view name,
                                            const std::vector<std::string_view>& candidates);

}  // namespace microslip
