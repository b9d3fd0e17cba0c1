// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip {

/// Composes a TOML file line by line. Numbers are the shortest text that reads back as the same
/// double.
class TomlLines {
 public:
  void table(std::string_view name);    ///< [name]
  void element(std::string_view name);  ///< [[name]]
  void add(std::string_view key, double value);
  void add(std::string_view key, std::size_t value);
  void add(std::string_view key, const std::vector<double>& values);
  void add(std::string_view key, std::string_view text);
  void raw(std::string_view text) { text_ += text; }
  /// Each line of the text as a comment.
  void comment(std::string_view text);

  [[nodiscard]] std::string str() && { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace microslip
