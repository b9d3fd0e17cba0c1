// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// Looks at the brackets and dotted keys of TOML before it is parsed. The parser bounds the depth
/// of brackets only, and a tree of tables is freed by recursion: a key of a million parts would
/// exhaust the stack. Internal to io.
/// @throws FormatError  with its place, where brackets nest deeper than kDeepestNesting or a key
///                      has more than 16 parts.
void check_toml_nesting(std::string_view text, std::string_view file);

}  // namespace microslip
