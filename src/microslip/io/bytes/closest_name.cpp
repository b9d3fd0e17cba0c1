// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/closest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace microslip {
namespace {

/// The optimal-string-alignment distance by the usual table, of which three rows are kept.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two_above(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(two_above, above);
    std::swap(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], two_above[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

bool completes(std::string_view candidate, std::string_view name) {
  return candidate.size() > name.size() && candidate.starts_with(name) &&
         candidate[name.size()] == '_';
}

}  // namespace

std::string_view closest_name(std::string_view name,
                              const std::vector<std::string_view>& candidates) {
  std::string_view closest;
  std::size_t least = name.size() / 3 + 1;
  for (const std::string_view candidate : candidates) {
    if (completes(candidate, name)) return candidate;
    if (name.size() > candidate.size() + least) continue;  // too far, and perhaps very long
    const std::size_t distance = edit_distance(name, candidate);
    if (distance >= least) continue;
    least = distance;
    closest = candidate;
  }
  return closest;
}

}  // namespace microslip
