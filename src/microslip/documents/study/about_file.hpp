// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// @file
/// about.toml, schema microslip.about/1: what stands at the head of a report. All keys but the
/// first are optional; values are texts of one line.
///
///     schema = "microslip.about/1"
///     title = "Bolted plate"
///     object, customer, order, operator, date = "…"
///     logo = "logo.png"   PNG, JPEG or SVG, up to 1 MiB, beside the file

namespace microslip {

/// What about.toml has.
struct ReportAbout {
  std::string title;  ///< empty: none
  /// What it is called in a report and the text, of the keys that are there: Object, Customer,
  /// Order, Operator, Date.
  std::vector<std::pair<std::string, std::string>> particulars;
  std::string logo;       ///< bytes of the picture; empty: none
  std::string logo_type;  ///< its type in an address, `image/png` for instance
};

/// @param text  of the file.
/// @param file  its path: the logo is beside it.
/// @throws FormatError  for text that is no TOML, another schema, keys unknown, texts that are
///                      empty or of more than a line, and a logo that is no such picture.
/// @throws InputError   for a value of a wrong type.
/// @throws FileError    where the logo cannot be read.
[[nodiscard]] ReportAbout parse_about(std::string_view text, std::string_view file);

/// parse_about() of a file. @throws FileError, FormatError, InputError
[[nodiscard]] ReportAbout read_about(const std::string& path);

}  // namespace microslip
