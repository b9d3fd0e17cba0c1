// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// The values at the given indices, in their order: values[which[0]], values[which[1]], … Empty
/// for an absent column, which has no values. Internal to the library.
/// @param which  each below the number of values, where there are any.
template <typename Value>
[[nodiscard]] std::vector<Value> gather(const std::vector<Value>& values,
                                        std::span<const std::size_t> which) {
  std::vector<Value> gathered;
  if (values.empty()) return gathered;
  gathered.reserve(which.size());
  for (const std::size_t i : which) gathered.push_back(values[i]);
  return gathered;
}

}  // namespace microslip
