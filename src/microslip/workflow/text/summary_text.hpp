// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"

/// @file
/// The form of what the subcommands say to a person.

namespace microslip {

/// One fact: name and text in two columns.
[[nodiscard]] std::string line(std::string_view name, std::string_view text);

/// Breaks a paragraph between words, later lines indented. An option with its value, between grave
/// accents, is one word.
[[nodiscard]] std::string wrapped(std::string_view first, std::string_view text, std::size_t indent,
                                  std::size_t width = 78);

/// The end of a path, of so many characters at most: it distinguishes files.
[[nodiscard]] std::string shortened(const std::string& source, std::size_t width);

/// "1 level", "3 levels".
[[nodiscard]] std::string counted(std::size_t count, std::string_view what);

/// A record and what is to be looked at in it.
struct FlaggedRecord {
  std::string source;
  std::vector<Warning> flags;
};

/// Each kind once, "CODE (3 of 9 levels, first SOURCE)", with the text of the first that has it.
/// @param noun          "levels". @param source_width  most characters of the source.
[[nodiscard]] std::vector<Warning> kinds_of(const std::vector<FlaggedRecord>& records,
                                            std::string_view noun, std::size_t source_width);

}  // namespace microslip
