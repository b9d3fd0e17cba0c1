// SPDX-License-Identifier: MIT
#include "microslip/io/config/toml_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip {
namespace {

/// A basic string of TOML.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace

void TomlLines::table(std::string_view name) { text_ += fmt::format("\n[{}]\n", name); }

void TomlLines::element(std::string_view name) { text_ += fmt::format("\n[[{}]]\n", name); }

void TomlLines::add(std::string_view key, double value) {
  text_ += fmt::format("{} = {}\n", key, value);
}

void TomlLines::add(std::string_view key, std::size_t value) {
  text_ += fmt::format("{} = {}\n", key, value);
}

void TomlLines::add(std::string_view key, const std::vector<double>& values) {
  text_ += fmt::format("{} = [{}]\n", key, fmt::join(values, ", "));
}

void TomlLines::add(std::string_view key, std::string_view text) {
  text_ += fmt::format("{} = {}\n", key, quoted(text));
}

void TomlLines::comment(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    text_ += "# ";
    for (const char c : text.substr(0, end)) {
      const auto byte = static_cast<unsigned char>(c);
      text_ += byte < 0x20 || byte == 0x7F ? ' ' : c;
    }
    text_ += '\n';
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
}

}  // namespace microslip
