// SPDX-License-Identifier: MIT
#include "microslip/io/mat_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <new>
#include <numeric>

#include "microslip/base/error.hpp"
#include "microslip/io/hdf5_reader.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/mat5_reader.hpp"
#include "microslip/io/text.hpp"

namespace microslip {
namespace {

constexpr std::size_t kHeadSize = 520;
constexpr std::string_view kHdf5Signature = "\x89HDF\r\n\x1A\n";

MatTree read_any_version(const std::string& path, const MatReadOptions& options) {
  if (path == "-") throw FileError("standard input", "cannot hold a MAT file", "Name a file.");
  const std::string head = read_file_head(path, kHeadSize);
  if (head.starts_with(kHdf5Signature) ||
      (head.size() == kHeadSize && head.ends_with(kHdf5Signature))) {
    return read_mat73_tree(path, options);
  }
  MatFileStream file(path, options.progress);
  if (head.starts_with("MATLAB 5.0") ||
      (head.size() >= 128 && (head.substr(126, 2) == "IM" || head.substr(126, 2) == "MI"))) {
    return read_mat5(file, options);
  }
  throw FormatError({.file = path}, "a MAT file of MATLAB, version 5 or 7.3",
                    head.empty() ? "nothing" : "a file that starts " + in_quotes(head, 20),
                    "In MATLAB: save('name.mat', ..., '-v7').");
}

}  // namespace

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

std::string list_of_names(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    list += fmt::format("{}{}", i == 0 ? "" : ", ", in_quotes(names[i]));
  }
  if (names.size() > kMost) list += fmt::format(", … ({} in all)", names.size());
  return names.empty() ? "nothing" : list;
}

MatTree read_mat_tree(const std::string& path, const MatReadOptions& options) {
  try {
    return read_any_version(path, options);
  } catch (const std::bad_alloc&) {
    throw FileError(path, "does not fit into memory");
  }
}

}  // namespace microslip
