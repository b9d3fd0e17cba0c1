// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/io/config/named_values.hpp"

/// @file
/// Lists of texts in records.

namespace microslip {

/// The texts of a JSON list, as of the warnings in an identification; what is no text is left out.
/// Empty for what is no list.
[[nodiscard]] std::vector<std::string> texts_of(const JsonText& list);

/// The JSON list of texts that texts_of() reads back; what is no UTF-8 in them is replaced.
[[nodiscard]] JsonText list_of_texts(const std::vector<std::string>& texts);

}  // namespace microslip
