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

std::string spelled(std::string_view option, const SpellOption& spell) {
  const std::string_view name = option.substr(0, option.find(' '));
  std::string text = "--" + std::string(name);
  std::ranges::replace(text, '_', '-');
  return spell(name, text).append(option.substr(name.size()));
}

}  // namespace

std::string with_option_names(std::string_view text) {
  return with_option_names(text,
                           [](std::string_view, const std::string& option) { return option; });
}

std::string with_option_names(std::string_view text, const SpellOption& spell) {
  std::string result;
  for (;;) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == text.npos ? begin : text.find('`', begin + 1);
    if (end == text.npos) return result.append(text);
    const std::string_view inside = text.substr(begin + 1, end - begin - 1);
    if (is_option(inside)) {
      result.append(text.substr(0, begin)).append(spelled(inside, spell));
      text.remove_prefix(end + 1);
    } else {  // the second may begin an option
      result.append(text.substr(0, end));
      text.remove_prefix(end);
    }
  }
}

}  // namespace microslip::app
