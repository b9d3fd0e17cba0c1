// SPDX-License-Identifier: MIT
#include "arguments/option_names.hpp"

#include <algorithm>

namespace microslip::app {
namespace {

/// "assume_units force=N" is one, "microslip frf --help" is none.
bool is_option(std::string_view text) {
  const std::string_view name = text.substr(0, text.find(' '));
  return !name.empty() && name != "microslip" &&
         std::ranges::all_of(name, [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

std::string spelled(std::string_view option) {
  std::string text = "--" + std::string(option);
  const auto end =
      text.begin() + static_cast<std::ptrdiff_t>(std::min(text.find(' '), text.size()));
  std::replace(text.begin(), end, '_', '-');
  return text;
}

}  // namespace

std::string with_option_names(std::string_view text) {
  std::string result;
  for (;;) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == text.npos ? begin : text.find('`', begin + 1);
    if (end == text.npos) return result.append(text);
    const std::string_view inside = text.substr(begin + 1, end - begin - 1);
    if (is_option(inside)) {
      result.append(text.substr(0, begin)).append(spelled(inside));
      text.remove_prefix(end + 1);
    } else {  // the second may begin an option
      result.append(text.substr(0, end));
      text.remove_prefix(end);
    }
  }
}

}  // namespace microslip::app
