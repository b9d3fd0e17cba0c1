// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_value.hpp"

#include <fmt/format.h>

#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat_file.hpp"
#include "microslip/io/mat/mat_path.hpp"

namespace microslip {
namespace {

/// Calls `use` with the place in the file's tree.
template <class Use>
auto at_place(const std::string& path, std::string_view variable, const Use& use) {
  MatTree tree = read_mat_tree(path, {.only = first_name(variable), .progress = {}});
  return use(follow(tree.root, variable, path));
}

[[noreturn]] void fail(const std::string& path, std::string_view variable, const MatPlace& place,
                       std::string_view rule) {
  throw InputError(fmt::format("{}: {}", path, in_quotes(variable, 200)), describe(*place.value),
                   rule);
}

}  // namespace

MatArray read_mat_array(const std::string& path, std::string_view variable) {
  return at_place(path, variable, [&](const MatPlace& place) -> MatArray {
    if (place.value->kind != MatValue::Kind::kNumbers) {
      fail(path, variable, place, "must be an array of numbers");
    }
    return {std::move(place.value->sizes), std::move(place.value->real),
            std::move(place.value->imaginary)};
  });
}

std::vector<double> read_mat_numbers(const std::string& path, std::string_view variable) {
  return at_place(path, variable, [&](const MatPlace& place) {
    if (place.value->kind != MatValue::Kind::kNumbers || !place.value->imaginary.empty()) {
      fail(path, variable, place, "must be an array of real numbers");
    }
    return std::move(place.value->real);
  });
}

std::string read_mat_text(const std::string& path, std::string_view variable) {
  return at_place(path, variable, [&](const MatPlace& place) -> std::string {
    const MatValue& value = *place.value;
    if (value.kind != MatValue::Kind::kText || value.texts.size() > 1) {
      fail(path, variable, place, "must be text of one row");
    }
    return value.texts.empty() ? std::string{} : value.texts.front();
  });
}

std::vector<std::string> mat_fields(const std::string& path, std::string_view variable) {
  return at_place(path, variable, [&](const MatPlace& place) {
    if (place.value->kind != MatValue::Kind::kStruct) {
      fail(path, variable, place, "must be a struct");
    }
    return place.value->fields;
  });
}

std::size_t mat_count(const std::string& path, std::string_view variable) {
  return at_place(path, variable, [](const MatPlace& place) {
    return place.element ? std::size_t{1} : place.value->count();
  });
}

}  // namespace microslip
