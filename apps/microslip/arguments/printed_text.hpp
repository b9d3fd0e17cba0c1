// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace microslip::app {

/// Lines fit for a terminal: all but line breaks as printable() has it, for names of files,
/// channels and joints may hold what a terminal obeys.
[[nodiscard]] std::string printed_text(std::string_view text);

/// Prints printed_text(). What cannot be written shows in std::ferror() of the stream.
void print_text(std::FILE* stream, std::string_view text);

}  // namespace microslip::app
