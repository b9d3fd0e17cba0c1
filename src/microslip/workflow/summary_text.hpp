// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// @file
/// The form of what the subcommands say to a person.

namespace microslip {

/// One fact: name and text in two columns.
[[nodiscard]] std::string line(std::string_view name, std::string_view text);

/// Breaks a paragraph between words, later lines indented.
[[nodiscard]] std::string wrapped(std::string_view first, std::string_view text, std::size_t indent,
                                  std::size_t width = 78);

/// The end of a path, of so many characters at most: it tells files apart.
[[nodiscard]] std::string shortened(const std::string& source, std::size_t width);

}  // namespace microslip
