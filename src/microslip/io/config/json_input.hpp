// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// JSON from files of any origin. Internal to io: no public header includes it.

namespace microslip {

using Json = nlohmann::ordered_json;

/// Nothing that is written here comes near it; it bounds the work that a broken file can cause.
inline constexpr std::size_t kMostKeys = 1000;

/// @throws FormatError  for a syntax error, with its place; a number beyond the range of doubles; a
///                      key given twice in one object; nesting deeper than kDeepestNesting or an
///                      object larger than kMostKeys.
[[nodiscard]] Json parse_json(std::string_view text, std::string_view file);

/// An object of a file; messages name its keys as `file: density[2].from_N`.
class JsonObject {
 public:
  /// @param path  of the object in the file: "density[2]"; empty at the top.
  /// @throws FormatError  where the value is no object.
  JsonObject(const Json& value, std::string_view file, std::string_view path);

  /// @throws FormatError  naming the first key that is not among them.
  void allow_only(const std::vector<std::string_view>& keys) const;

  [[nodiscard]] bool has(std::string_view key) const;

  /// @throws FormatError  where the key is missing.
  [[nodiscard]] const Json& at(std::string_view key) const;

  /// @throws FormatError  where it is missing. @throws InputError  where it has another type.
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const;
  [[nodiscard]] const Json& array(std::string_view key) const;

  /// `file: path.key`.
  [[nodiscard]] std::string name(std::string_view key) const;

 private:
  const Json& value_;
  std::string file_;
  std::string path_;
};

/// The value as a message shows it: a number, a text in quotes, "an array of 3"…
[[nodiscard]] std::string described(const Json& value);

}  // namespace microslip
