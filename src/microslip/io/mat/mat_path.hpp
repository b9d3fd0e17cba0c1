// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/io/recordings/mat_tree.hpp"

namespace microslip {

/// The name of the variable that a path such as `FRdata.ResponseControl(3).force` starts with.
[[nodiscard]] std::string_view first_name(std::string_view path);

/// A place in a file: a value, or one element of an array of structs.
struct MatPlace {
  MatValue* value = nullptr;
  std::optional<std::size_t> element;  ///< from 0
};

/// Follows a path from the root of a tree; an empty one stays there.
/// @throws InputError  naming the path up to the first step that fails, and what there is.
[[nodiscard]] MatPlace follow(MatValue& root, std::string_view path, const std::string& file);

/// The field of an element; null where there is none of the name.
[[nodiscard]] MatValue* field_of(MatValue& value, std::size_t element, std::string_view name);
/// The same by its number in `fields`, from 0.
[[nodiscard]] MatValue* field_at(MatValue& value, std::size_t element, std::size_t index);

}  // namespace microslip
