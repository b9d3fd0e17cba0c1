// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"

/// @file
/// Common to the readers of JSON and TOML: limits, the names of keys and the words of
/// their errors. An object is one of JSON or a table of TOML; its path in the file is "density[2]",
/// empty at the top. Internal to io.

namespace microslip {

/// Nothing that is written here comes near it; it bounds the recursion that a broken file can
/// cause.
inline constexpr int kDeepestNesting = 64;

/// @param format  JSON or TOML. @throws FormatError  where there is nothing but blanks, or a file
///     of this program that is written in another one.
void require_content(std::string_view text, KindFormat format, std::string_view file);

/// "density[2].from_N"; the key alone at the top.
[[nodiscard]] std::string key_path(std::string_view path, std::string_view key);

/// A key that is not among the `allowed`; suggests the one that was probably meant.
[[nodiscard]] FormatError unknown_key(const TextPlace& place, std::string_view path,
                                      std::string_view key,
                                      const std::vector<std::string_view>& allowed);

/// @param present  the keys that are there.
[[nodiscard]] FormatError missing_key(const TextPlace& place, std::string_view path,
                                      std::string_view key,
                                      const std::vector<std::string_view>& present);

inline constexpr std::string_view kNumber = "a number";
inline constexpr std::string_view kText = "a text in quotes";

/// @param name   of the key, with its file and place.
/// @param found  the value as a message shows it.
/// @param type   it must have: kNumber, kText, "an array"…
[[nodiscard]] InputError wrong_type(std::string_view name, std::string_view found,
                                    std::string_view type, std::string_view remedy = {});

/// @param content  of such a file: "a joint". @throws FormatError  where `found` is another schema.
void check_schema(const TextPlace& place, std::string_view found, std::string_view schema,
                  std::string_view content);

}  // namespace microslip
