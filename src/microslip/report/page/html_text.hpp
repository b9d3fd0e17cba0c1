// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// @file
/// Text as it may stand in an HTML file. Internal to report.

namespace microslip {

/// For the content of an element and for an attribute between double quotes: & < > " ' become
/// character references, control characters and what is no UTF-8 become U+FFFD.
[[nodiscard]] std::string html_text(std::string_view text);

/// A word for `id` and the like, of the letters, digits and hyphens of a text.
[[nodiscard]] std::string html_id(std::string_view text);

/// [RFC 4648, section 4]
[[nodiscard]] std::string base64(std::string_view bytes);

/// An SVG picture as an address between double quotes [RFC 2397]: a quarter shorter than in base64.
/// Runs of blanks and line breaks become one blank; groups that hold nothing are left out.
[[nodiscard]] std::string svg_address(std::string_view svg);

/// Hexadecimal digits as the bytes that they stand for. @param digits  an even number of them.
[[nodiscard]] std::string bytes_of_hex(std::string_view digits);

}  // namespace microslip
