// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/mat_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat_file.hpp"
#include "microslip/io/mat/mat_path.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

using MatrixKind = MatValue::Kind;

bool is_matrix(const MatValue& value) {
  return value.kind == MatrixKind::kSparse ||
         (value.kind == MatrixKind::kNumbers && !value.is_vector());
}

/// The names of all matrices in a struct of one element, and in those within it.
void add_matrices(const MatValue& value, const std::string& inside,
                  std::vector<std::string>& names) {
  if (value.kind != MatrixKind::kStruct || value.count() != 1) return;
  for (std::size_t i = 0; i < value.children.size(); ++i) {
    const std::string name = inside.empty() ? value.fields[i] : inside + "." + value.fields[i];
    if (is_matrix(value.children[i])) names.push_back(name);
    add_matrices(value.children[i], name, names);
  }
}

std::string only_matrix(const MatValue& root, const std::string& path) {
  std::vector<std::string> names;
  add_matrices(root, {}, names);
  if (names.size() == 1) return names.front();
  throw InputError(path, fmt::format("{} matrices", names.size()),
                   fmt::format("must be one; there is {}", list_of_names(names)),
                   fmt::format("Name one after a colon, {}:{}.", file_name(path),
                               names.empty() ? "K" : names.front()));
}

/// The path as the tree has it.
std::string with_dots(std::string_view variable) {
  if (variable.starts_with('/')) variable.remove_prefix(1);
  std::string path(variable);
  std::ranges::replace(path, '/', '.');
  return path;
}

void check_form(const MatValue& value, const std::string& name) {
  const bool numbers = value.kind == MatrixKind::kSparse || value.kind == MatrixKind::kNumbers;
  if (!numbers || value.sizes.size() != 2 || value.sizes[0] != value.sizes[1]) {
    throw InputError(name, describe(value), "must be a square matrix");
  }
  if (!value.imaginary.empty()) {
    throw InputError(name, describe(value), "must be real", "Mass and stiffness are real.");
  }
  if (value.sizes[0] == 0 || value.sizes[0] > kMostDegreesOfFreedom) {
    throw InputError(name, fmt::format("{} rows", value.sizes[0]),
                     fmt::format("must have 1 to {}", kMostDegreesOfFreedom));
  }
}

class EntryList {
 public:
  EntryList(std::size_t size, std::string name) : name_(std::move(name)) { entries_.size = size; }

  void add(std::size_t row, std::size_t column, double value) {
    if (value == 0.0) return;
    if (!std::isfinite(value)) {
      throw InputError(fmt::format("{}: entry ({}, {})", name_, row + 1, column + 1), value,
                       "must be finite");
    }
    entries_.row.push_back(static_cast<std::int32_t>(row));
    entries_.column.push_back(static_cast<std::int32_t>(column));
    entries_.value.push_back(value);
  }

  MatrixEntries take() { return std::move(entries_); }

 private:
  std::string name_;
  MatrixEntries entries_ = {.size = 0, .row = {}, .column = {}, .value = {}};
};

MatrixEntries entries_of(const MatValue& value, const std::string& name) {
  check_form(value, name);
  const std::size_t size = value.sizes[0];
  EntryList list(size, name);
  for (std::size_t column = 0; column < size; ++column) {
    if (value.kind == MatrixKind::kNumbers) {
      for (std::size_t row = 0; row < size; ++row)
        list.add(row, column, value.real[column * size + row]);
      continue;
    }
    const auto end = static_cast<std::size_t>(value.column_start[column + 1]);
    for (auto i = static_cast<std::size_t>(value.column_start[column]); i < end; ++i) {
      list.add(static_cast<std::size_t>(value.row[i]), column, value.real[i]);
    }
  }
  return list.take();
}

}  // namespace

MatrixEntries read_mat_entries(const std::string& path, std::string_view variable) {
  std::string name = with_dots(variable);
  MatReadOptions options;
  if (!name.empty()) options.only = first_name(name);
  MatTree tree = read_mat_tree(path, options);
  if (name.empty() && !is_matrix(tree.root)) name = only_matrix(tree.root, path);
  const MatPlace place = follow(tree.root, name, path);
  return entries_of(*place.value, name.empty() ? path : path + ":" + name);
}

}  // namespace microslip
