// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"

/// @file
/// Pieces of a file's text as messages show them.

namespace microslip {

/// The text in single quotes, fit for a message of one line: cut after `limit` bytes with its
/// length in all, bytes that are no printable UTF-8 written as \xNN.
[[nodiscard]] std::string in_quotes(std::string_view text, std::size_t limit = 40);

/// Line and column, both from 1, of the byte at `offset`; the column counts characters of UTF-8.
[[nodiscard]] TextPlace place_at(std::string_view text, std::size_t offset, std::string_view file);

/// The text without blanks and tabs at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Appends the shortest decimal text that reads back as the same double, whatever the locale.
void append_number(std::string& text, double value);

}  // namespace microslip
