// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_value.hpp"

#include <fmt/format.h>

#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat_file.hpp"
#include "microslip/io/mat/mat_path.hpp"

namespace microslip {
namespace {

[[noreturn]] void fail(const std::string& path, std::string_view variable, const MatPlace& place,
                       std::string_view rule) {
  throw InputError(fmt::format("{}: {}", path, in_quotes(variable, 200)), describe(*place.value),
                   rule);
}

}  // namespace

MatVariable::MatVariable(std::string path, std::string_view variable)
    : path_(std::move(path)),
      tree_(std::make_shared<MatTree>(
          read_mat_tree(path_, {.only = first_name(variable), .progress = {}}))) {}

MatVariable::MatVariable(InputStream& file, std::string_view variable)
    : path_(file.name()),
      tree_(std::make_shared<MatTree>(
          read_mat_tree(file, {.only = first_name(variable), .progress = {}}))) {}

MatArray MatVariable::array(std::string_view variable) const {
  const MatPlace place = follow(tree_->root, variable, path_);
  if (place.value->kind != MatValue::Kind::kNumbers) {
    fail(path_, variable, place, "must be an array of numbers");
  }
  return {place.value->sizes, place.value->real, place.value->imaginary};
}

std::vector<double> MatVariable::numbers(std::string_view variable) const {
  const MatPlace place = follow(tree_->root, variable, path_);
  if (place.value->kind != MatValue::Kind::kNumbers || !place.value->imaginary.empty()) {
    fail(path_, variable, place, "must be an array of real numbers");
  }
  return place.value->real;
}

std::string MatVariable::text(std::string_view variable) const {
  const MatPlace place = follow(tree_->root, variable, path_);
  const MatValue& value = *place.value;
  if (value.kind != MatValue::Kind::kText || value.texts.size() > 1) {
    fail(path_, variable, place, "must be text of one row");
  }
  return value.texts.empty() ? std::string{} : value.texts.front();
}

std::vector<std::string> MatVariable::fields(std::string_view variable) const {
  const MatPlace place = follow(tree_->root, variable, path_);
  if (place.value->kind != MatValue::Kind::kStruct) {
    fail(path_, variable, place, "must be a struct");
  }
  return place.value->fields;
}

std::size_t MatVariable::count(std::string_view variable) const {
  const MatPlace place = follow(tree_->root, variable, path_);
  return place.element ? std::size_t{1} : place.value->count();
}

MatArray read_mat_array(const std::string& path, std::string_view variable) {
  return MatVariable(path, variable).array(variable);
}

std::vector<double> read_mat_numbers(const std::string& path, std::string_view variable) {
  return MatVariable(path, variable).numbers(variable);
}

std::string read_mat_text(const std::string& path, std::string_view variable) {
  return MatVariable(path, variable).text(variable);
}

std::vector<std::string> mat_fields(const std::string& path, std::string_view variable) {
  return MatVariable(path, variable).fields(variable);
}

std::size_t mat_count(const std::string& path, std::string_view variable) {
  return MatVariable(path, variable).count(variable);
}

}  // namespace microslip
