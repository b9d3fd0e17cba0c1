// SPDX-License-Identifier: MIT
#include "microslip/base/codes.hpp"

#include <fmt/format.h>

namespace microslip {

void add_code(std::string& codes, std::string_view code) {
  const bool is_there =
      fmt::format(" {} ", codes).find(fmt::format(" {} ", code)) != std::string::npos;
  if (code.empty() || is_there) return;
  if (!codes.empty()) codes += ' ';
  codes += code;
}

std::string joined_codes(const std::vector<Warning>& warnings) {
  std::string codes;
  for (const Warning& warning : warnings) add_code(codes, warning.code);
  return codes;
}

}  // namespace microslip
