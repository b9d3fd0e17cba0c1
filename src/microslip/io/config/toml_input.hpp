// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"

// Without it a debug build of the parser aborts for "[=", which is a syntax error like any other:
// the same condition is tested and reported after the assertion.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>

/// @file
/// TOML 1.0 from files of any origin. Internal to io: no public header includes it.

namespace microslip {

/// @throws FormatError  for an empty file, another format, a syntax error, a number beyond its type
///                      or a key given twice, with the place; for nesting deeper than
///                      kDeepestNesting or a dotted key of more than 16 parts.
[[nodiscard]] toml::table parse_toml(std::string_view text, std::string_view file);

/// A table of a file, which must outlive it; messages name its keys as
/// `file:line:column: accelerometer[1].position_m`. A place is that of the value, or of the table
/// where a key is missing.
class TomlTable {
 public:
  /// @param path  of the table in the file: "accelerometer[1]"; empty at the top.
  TomlTable(const toml::table& table, std::string_view file, std::string_view path = {});

  /// @throws FormatError  naming the first key that is not among them.
  void allow_only(const std::vector<std::string_view>& keys) const;

  /// Its keys, in alphabetical order.
  [[nodiscard]] std::vector<std::string> keys() const;
  [[nodiscard]] bool has(std::string_view key) const;
  /// Whether its value is a text; false where the key is missing.
  [[nodiscard]] bool is_text(std::string_view key) const;

  // Each throws FormatError where the key is missing, and InputError where it has another type.

  /// An integer or a float, which may be `inf` or `nan`.
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const;
  /// An integer, 0 or more.
  [[nodiscard]] std::size_t whole(std::string_view key) const;
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  [[nodiscard]] bool boolean(std::string_view key) const;
  [[nodiscard]] TomlTable table(std::string_view key) const;
  /// [[key]], or an array of inline tables.
  [[nodiscard]] std::vector<TomlTable> tables(std::string_view key) const;
  /// tables(), or the one table [key].
  [[nodiscard]] std::vector<TomlTable> one_or_more(std::string_view key) const;

  /// `file:line:column: path.key`.
  [[nodiscard]] std::string name(std::string_view key) const;
  /// `file:line:column: path.key[index]`, of an element of an array.
  [[nodiscard]] std::string name(std::string_view key, std::size_t index) const;

  /// Of the value; of the table where the key is missing.
  [[nodiscard]] TextPlace place(std::string_view key) const;

 private:
  [[nodiscard]] const toml::node& at(std::string_view key) const;
  [[nodiscard]] std::string element_path(std::string_view key, std::size_t index) const;
  [[nodiscard]] double number_of(const toml::node& node, std::string_view path) const;
  [[nodiscard]] InputError wrong(const toml::node& node, std::string_view path,
                                 std::string_view type, std::string_view remedy = {}) const;

  const toml::table& table_;
  std::string file_;
  std::string path_;
};

/// `file:line:column: path` for a path from the top, "accelerometer[1].position_m"; the place is
/// that of the nearest table around it where it is missing.
[[nodiscard]] std::string toml_name(const toml::table& top, std::string_view file,
                                    std::string_view path);

/// The value as a message shows it: a number, a text in quotes, "an array of 3"…
[[nodiscard]] std::string described(const toml::node& value);

}  // namespace microslip
