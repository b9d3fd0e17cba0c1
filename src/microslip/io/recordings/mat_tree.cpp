// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/mat_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "microslip/io/bytes/text.hpp"

namespace microslip {

std::size_t MatValue::count() const {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{1}, std::multiplies<>{});
}

bool MatValue::is_vector() const {
  return std::ranges::count_if(sizes, [](std::size_t n) { return n != 1; }) <= 1;
}

std::string describe(const MatValue& value) {
  std::string sizes;
  for (const std::size_t n : value.sizes) {
    sizes += fmt::format("{}{}", sizes.empty() ? "" : " × ", n);
  }
  switch (value.kind) {
    case MatValue::Kind::kNumbers:
      return fmt::format("{} numbers of {}", value.imaginary.empty() ? "real" : "complex", sizes);
    case MatValue::Kind::kSparse:
      return fmt::format("a sparse matrix of {} numbers of {}",
                         value.imaginary.empty() ? "real" : "complex", sizes);
    case MatValue::Kind::kText:
      return fmt::format("text of {}", sizes);
    case MatValue::Kind::kCell:
      return fmt::format("a cell array of {}", sizes);
    case MatValue::Kind::kStruct:
      return fmt::format("a struct of {} with {}", sizes, list_of_names(value.fields));
    default:
      return value.other.empty() ? "an array of " + sizes : value.other;
  }
}

std::string checked_sparse(MatValue& value) {
  const std::vector<std::int64_t>& start = value.column_start;
  if (value.sizes.size() != 2) return fmt::format("{} dimensions", value.sizes.size());
  if (start.size() != value.sizes[1] + 1) {
    return fmt::format("{} starts of {} columns", start.size(), value.sizes[1]);
  }
  const std::size_t there = std::min(value.row.size(), value.real.size());
  if (start.front() != 0) return fmt::format("columns that start at {}", start.front());
  for (std::size_t i = 1; i < start.size(); ++i) {
    if (start[i] < start[i - 1]) return fmt::format("a column {} that ends before it starts", i);
  }
  const auto count = static_cast<std::size_t>(start.back());
  if (count > there) return fmt::format("{} rows and numbers of {}", there, count);
  value.row.resize(count);
  value.real.resize(count);
  if (!value.imaginary.empty()) value.imaginary.resize(count);
  const auto rows = static_cast<std::int64_t>(value.sizes[0]);
  const auto bad =
      std::ranges::find_if(value.row, [&](auto row) { return row < 0 || row >= rows; });
  if (bad != value.row.end()) return fmt::format("a row {} of {}", *bad + 1, rows);
  return {};
}

std::optional<MatValue> octave_range(double base, double limit, double increment,
                                     std::size_t most) {
  const double steps = (limit - base) / increment;
  // As Octave counts them: the last one may miss the limit by rounding.
  constexpr double kRounding = 3.0 * std::numeric_limits<double>::epsilon();
  const double count = std::floor(steps + kRounding * std::max(1.0, std::abs(steps))) + 1.0;
  if (!std::isfinite(base) || !(count <= static_cast<double>(most))) return std::nullopt;
  MatValue value;
  value.kind = MatValue::Kind::kNumbers;
  value.real.resize(count > 0.0 ? static_cast<std::size_t>(count) : 0);
  for (std::size_t i = 0; i < value.real.size(); ++i) {
    value.real[i] = base + static_cast<double>(i) * increment;
  }
  value.sizes = {1, value.real.size()};
  return value;
}

MatValue long_range(double base, double limit, double increment) {
  MatValue value;
  value.kind = MatValue::Kind::kOther;
  value.sizes = {1, 1};
  value.other = fmt::format("a range {}:{}:{} of more values than any record of the file", base,
                            increment, limit);
  return value;
}

std::optional<MatValue> structs_of_columns(MatValue columns) {
  MatValue value;
  value.kind = MatValue::Kind::kStruct;
  value.in_order = columns.in_order;
  value.fields = std::move(columns.fields);
  for (const MatValue& column : columns.children) {
    if (value.sizes.empty()) value.sizes = column.sizes;
    if (column.kind != MatValue::Kind::kCell || column.sizes != value.sizes) return std::nullopt;
  }
  if (value.sizes.empty()) return std::nullopt;
  for (std::size_t i = 0; i < value.count(); ++i) {
    for (MatValue& column : columns.children)
      value.children.push_back(std::move(column.children[i]));
  }
  return value;
}

std::string other_class(std::string_view name) {
  return "an object of the class " + in_quotes(name);
}

}  // namespace microslip
