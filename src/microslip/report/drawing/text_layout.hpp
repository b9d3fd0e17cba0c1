// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// @file
/// Size and line breaks of texts. Internal to report.

namespace microslip {

/// UTF-8 fit to be shown on one line: control characters become blanks, bytes that are no UTF-8 and
/// characters that XML does not know become U+FFFD.
[[nodiscard]] std::string shown_text(std::string_view text);

struct Font {
  double size = 12.0;  ///< px
  bool bold = false;
};

/// The width of the text in DejaVu Sans, px; exact for ASCII but for rounding, roughly for the
/// rest.
[[nodiscard]] double text_width(std::string_view text, Font font);

/// The shown text broken at blanks into lines of at most `width` px; a longer word is broken
/// anywhere. Nothing for a blank text.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, double width, Font font);

}  // namespace microslip
