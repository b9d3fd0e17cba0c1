// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// The rows of a matrix of characters, stored column by column, as UTF-8, without blanks and zeros
/// at their ends where there are several. Fewer than rows·columns units make one row cut short.
[[nodiscard]] std::vector<std::string> text_rows(std::u16string_view units, std::size_t rows);

/// The same of rows whose characters are bytes, each row as units_of_bytes().
[[nodiscard]] std::vector<std::string> text_rows_of_bytes(std::string_view bytes, std::size_t rows);

/// Characters of one byte: UTF-8 where they can be, Latin-1 otherwise.
[[nodiscard]] std::u16string units_of_bytes(std::string_view bytes);

/// Can stand in a message: no control characters.
[[nodiscard]] bool is_plain_name(std::string_view name);

}  // namespace microslip
