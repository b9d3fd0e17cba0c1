// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace microslip {

/// UTF-16 in host byte order to UTF-8; halves of pairs that stand alone become U+FFFD.
[[nodiscard]] std::string utf8_of(std::u16string_view text);

/// How many bytes from the first on are UTF-8.
[[nodiscard]] std::size_t valid_utf8(std::string_view text);

/// UTF-8 to UTF-16; nothing where the bytes are not UTF-8.
[[nodiscard]] std::optional<std::u16string> utf16_of(std::string_view text);

}  // namespace microslip
