// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip {

/// Whether the bytes are whole characters of UTF-8.
[[nodiscard]] bool is_utf8(std::string_view text);

/// The text in UTF-8: as it is where it is valid, otherwise taken as CP1252, the character set of
/// Western Windows and, but for 32 places, Latin-1. Never fails; the five bytes that CP1252 does
/// not use become U+FFFD.
[[nodiscard]] std::string to_utf8(std::string_view text);

}  // namespace microslip
