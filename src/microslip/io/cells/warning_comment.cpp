// SPDX-License-Identifier: MIT
#include "microslip/io/cells/warning_comment.hpp"

#include <fmt/format.h>

#include "microslip/io/cells/csv_cells.hpp"

namespace microslip {

std::string warning_comment(const Warning& warning) {
  return fmt::format("warning: {}: {}", warning.code, on_one_line(warning.text));
}

std::optional<Warning> parse_warning_comment(std::string_view comment) {
  constexpr std::string_view kStart = "warning: ";
  if (!comment.starts_with(kStart)) return std::nullopt;
  comment.remove_prefix(kStart.size());
  const std::size_t end = comment.find(": ");
  const std::string_view code = comment.substr(0, end);
  if (end == std::string_view::npos || code.empty() || code.find(' ') != std::string_view::npos) {
    return std::nullopt;
  }
  return Warning{std::string(code), std::string(comment.substr(end + 2))};
}

}  // namespace microslip
