// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/symmetric_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr double kAsymmetryAllowed = 1e-8;

/// An entry, and that across the diagonal.
struct Pair {
  std::int32_t row;
  std::int32_t column;  ///< ≤ row
  double lower;
  double upper;
};

std::string entry_name(std::string_view file, std::int32_t row, std::int32_t column) {
  return fmt::format("{}: entry ({}, {})", file, row + 1, column + 1);
}

/// Sorted, each place once.
std::vector<Pair> pairs_of(const MatrixEntries& entries) {
  std::vector<Pair> pairs;
  pairs.reserve(entries.value.size());
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    const std::int32_t row = entries.row[i];
    const std::int32_t column = entries.column[i];
    const double value = entries.value[i];
    if (row >= column) {
      pairs.push_back({row, column, value, 0.0});
    } else {
      pairs.push_back({column, row, 0.0, value});
    }
  }
  const auto place = [](const Pair& pair) { return std::pair(pair.column, pair.row); };
  std::ranges::stable_sort(pairs, {}, place);
  std::size_t kept = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    if (place(pairs[i]) == place(pairs[kept])) {
      pairs[kept].lower += pairs[i].lower;
      pairs[kept].upper += pairs[i].upper;
    } else {
      pairs[++kept] = pairs[i];
    }
  }
  if (!pairs.empty()) pairs.resize(kept + 1);
  return pairs;
}

/// Whether the places rise, which most programs write: then none is there twice.
bool rise(const std::vector<std::int32_t>& slow, const std::vector<std::int32_t>& fast) {
  for (std::size_t i = 1; i < slow.size(); ++i) {
    if (std::pair(slow[i - 1], fast[i - 1]) >= std::pair(slow[i], fast[i])) return false;
  }
  return true;
}

/// Entries whose place another one has.
std::size_t count_repeated(const MatrixEntries& entries) {
  if (rise(entries.column, entries.row) || rise(entries.row, entries.column)) return 0;
  std::vector<std::pair<std::int32_t, std::int32_t>> places;
  places.reserve(entries.value.size());
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    places.emplace_back(entries.row[i], entries.column[i]);
  }
  std::ranges::sort(places);
  return static_cast<std::size_t>(std::ranges::distance(std::ranges::unique(places)));
}

}  // namespace

void require_whole_lines(std::string_view text, const TextPlace& place) {
  if (text.ends_with('\n')) return;
  throw FormatError(place, "an end of line after the last entry",
                    "the end of the file: is it truncated?");
}

bool has_both_triangles(const MatrixEntries& entries) {
  std::vector<std::pair<std::int32_t, std::int32_t>> below;
  std::vector<std::pair<std::int32_t, std::int32_t>> above;
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    const std::int32_t row = entries.row[i];
    const std::int32_t column = entries.column[i];
    if (row > column) below.emplace_back(row, column);
    if (row < column) above.emplace_back(column, row);
  }
  std::ranges::sort(below);
  return std::ranges::any_of(
      above, [&](const auto& place) { return std::ranges::binary_search(below, place); });
}

SymmetricEntries symmetric_of_both(const MatrixEntries& entries, std::string_view file,
                                   std::string_view remedy) {
  const std::vector<Pair> pairs = pairs_of(entries);
  std::vector<double> diagonal(entries.size, 0.0);
  for (const Pair& pair : pairs) {
    if (pair.row == pair.column) diagonal[static_cast<std::size_t>(pair.row)] = pair.lower;
  }
  SymmetricEntries matrix{.size = entries.size,
                          .row = {},
                          .column = {},
                          .value = {},
                          .repeated = count_repeated(entries)};
  for (const Pair& pair : pairs) {
    const double scale = std::sqrt(std::abs(diagonal[static_cast<std::size_t>(pair.row)] *
                                            diagonal[static_cast<std::size_t>(pair.column)]));
    const bool off = pair.row != pair.column;
    if (off && !(std::abs(pair.lower - pair.upper) <= kAsymmetryAllowed * scale)) {
      throw InputError(entry_name(file, pair.row, pair.column), pair.lower,
                       fmt::format("must be that of ({}, {}), {:.9g}, as the matrix must be "
                                   "symmetric",
                                   pair.column + 1, pair.row + 1, pair.upper),
                       remedy);
    }
    matrix.row.push_back(pair.row);
    matrix.column.push_back(pair.column);
    matrix.value.push_back(off ? 0.5 * (pair.lower + pair.upper) : pair.lower);
  }
  return matrix;
}

SymmetricEntries symmetric_of_triangle(MatrixEntries entries, std::string_view file) {
  const std::size_t repeated = count_repeated(entries);
  bool upper = false;
  bool lower = false;
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    const bool is_upper = entries.column[i] > entries.row[i];
    upper = upper || is_upper;
    lower = lower || entries.column[i] < entries.row[i];
    if (upper && lower) {
      throw InputError(entry_name(file, entries.row[i], entries.column[i]), entries.value[i],
                       fmt::format("must lie in the {} triangle, as those before it",
                                   is_upper ? "lower" : "upper"),
                       "Only one triangle of a symmetric matrix is stored.");
    }
    if (is_upper) std::swap(entries.row[i], entries.column[i]);
  }
  return {.size = entries.size,
          .row = std::move(entries.row),
          .column = std::move(entries.column),
          .value = std::move(entries.value),
          .repeated = repeated};
}

}  // namespace microslip
