// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"

/// @file
/// Pieces of a file's text as messages show them.

namespace microslip {

/// Some programs begin a text of UTF-8 with it.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The text fit for a message of one line: bytes that are no printable UTF-8 written as `\xNN`,
/// among them controls and characters that turn the direction of a text.
[[nodiscard]] std::string printable(std::string_view text);

/// printable() in single quotes: cut after `limit` bytes with its length in all.
[[nodiscard]] std::string in_quotes(std::string_view text, std::size_t limit = 40);

/// Bytes of the printable character of UTF-8 that the text, not empty, starts with; 0 where there
/// is none.
[[nodiscard]] std::size_t printable_length(std::string_view text);

/// Line and column, both from 1, of the byte at `offset`; the column counts characters of UTF-8.
[[nodiscard]] TextPlace place_at(std::string_view text, std::size_t offset, std::string_view file);

/// The byte that place_at() calls so; the end of the text where there is none.
[[nodiscard]] std::size_t offset_of(std::string_view text, const TextPlace& place);

/// Text at the byte at `offset`: the beginning of the rest of its line, in quotes, or "the
/// end of the line" or of the file.
[[nodiscard]] std::string found_at(std::string_view text, std::size_t offset);

/// The text without blanks and tabs at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Texts with separators between them; of more than `most` the first ones: "a, b, and 4 more".
[[nodiscard]] std::string first_texts(const std::vector<std::string>& texts, std::size_t most,
                                      std::string_view separator = ", ");

/// first_texts() of names in quotes; "nothing" where there are none.
[[nodiscard]] std::string list_of_names(const std::vector<std::string>& names,
                                        std::size_t most = 12);

/// The text with the letters of ASCII in capitals.
[[nodiscard]] std::string in_capitals(std::string_view text);

/// Appends the shortest decimal text that reads back as the same double, whatever the locale.
void append_number(std::string& text, double value);

}  // namespace microslip
