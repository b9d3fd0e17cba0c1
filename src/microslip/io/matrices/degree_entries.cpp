// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/degree_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"

namespace microslip {
namespace {

using Triangles = DegreeMatrix::Triangles;

void add_degrees(const DegreeMatrix& matrix, std::vector<DegreeOfFreedom>& degrees) {
  for (const DegreeEntry& entry : matrix.entries) {
    degrees.push_back(entry.row);
    degrees.push_back(entry.column);
  }
  std::ranges::sort(degrees);
  const auto [first, last] = std::ranges::unique(degrees);
  degrees.erase(first, last);
}

/// Of one place twice, as where both triangles of a symmetric matrix are there, the sum would be
/// taken.
void require_single(const MatrixEntries& entries, const std::vector<DegreeOfFreedom>& degrees,
                    const DegreeMatrix& matrix) {
  std::vector<std::pair<std::int32_t, std::int32_t>> places;
  places.reserve(entries.value.size());
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    places.emplace_back(entries.row[i], entries.column[i]);
  }
  std::ranges::sort(places);
  const auto twice = std::ranges::adjacent_find(places);
  if (twice == places.end()) return;
  const auto text = [&](std::int32_t i) {
    return degree_text(degrees[static_cast<std::size_t>(i)]);
  };
  throw InputError(matrix.name, fmt::format("{} and {}", text(twice->first), text(twice->second)),
                   fmt::format("must have one entry: {}", matrix.twice));
}

/// A stiffness with entries beside a diagonal that is missing is none. (NCOL of a header of DMIG is
/// of rectangular matrices, and columns of zeros are not punched.)
void require_diagonal(const DegreeMatrix& matrix) {
  std::set<DegreeOfFreedom> diagonal;
  for (const DegreeEntry& entry : matrix.entries) {
    if (entry.row == entry.column) diagonal.insert(entry.row);
  }
  for (const DegreeEntry& entry : matrix.entries) {
    for (const DegreeOfFreedom& degree : {entry.row, entry.column}) {
      if (entry.value == 0.0 || diagonal.contains(degree)) continue;
      throw InputError(
          matrix.name, fmt::format("{} without its diagonal entry", degree_text(degree)),
          "must have one for each degree of freedom that has others", "Is the file truncated?");
    }
  }
}

MatrixEntries placed(const DegreeMatrix& matrix, const std::vector<DegreeOfFreedom>& degrees) {
  const auto index = [&](const DegreeOfFreedom& degree) {
    return static_cast<std::int32_t>(std::ranges::lower_bound(degrees, degree) - degrees.begin());
  };
  MatrixEntries entries{.size = degrees.size(), .row = {}, .column = {}, .value = {}};
  for (const DegreeEntry& entry : matrix.entries) {
    entries.row.push_back(index(entry.row));
    entries.column.push_back(index(entry.column));
    entries.value.push_back(entry.value);
  }
  return entries;
}

void put_below_the_diagonal(MatrixEntries& entries) {
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    if (entries.column[i] > entries.row[i]) std::swap(entries.row[i], entries.column[i]);
  }
}

SymmetricEntries entries_of(const DegreeMatrix& matrix,
                            const std::vector<DegreeOfFreedom>& degrees) {
  MatrixEntries entries = placed(matrix, degrees);
  const bool both = matrix.triangles == Triangles::kBoth ||
                    (matrix.triangles == Triangles::kEither && has_both_triangles(entries));
  if (!both) put_below_the_diagonal(entries);
  require_single(entries, degrees, matrix);
  SymmetricEntries result = both ? symmetric_of_both(entries, matrix.name, matrix.lacks)
                                 : symmetric_of_triangle(std::move(entries), matrix.name);
  result.is_open_ended = true;
  return result;
}

}  // namespace

std::string degree_text(const DegreeOfFreedom& degree) {
  return fmt::format("{} of {}", kNodalDirectionNames[static_cast<std::size_t>(degree.direction)],
                     degree.node);
}

StructuralMatrices matrices_of(const DegreeMatrix& stiffness, const DegreeMatrix& mass) {
  StructuralMatrices matrices;
  add_degrees(stiffness, matrices.degrees);
  add_degrees(mass, matrices.degrees);
  matrices.stiffness = entries_of(stiffness, matrices.degrees);
  require_diagonal(stiffness);
  matrices.mass = entries_of(mass, matrices.degrees);
  return matrices;
}

}  // namespace microslip
