// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// @file
/// Comments of tables that programs read: `key = value`, or `key[subject] = value` where there is
/// one for each of several things, as curves or conditions. Other comments are for people alone.

namespace microslip {

/// Returns such a comment.
/// @param key  lower-case letters, digits and `_`. @param subject  empty where there is only one.
[[nodiscard]] std::string comment_entry(std::string_view key, std::string_view subject,
                                        std::string_view value);

/// Returns the value of the first of these comments with the key and the subject, if there is one.
[[nodiscard]] std::optional<std::string> find_entry(std::span<const std::string> comments,
                                                    std::string_view key,
                                                    std::string_view subject = {});

/// Returns the first value that is a number: a line on a file that is named like an entry is none.
[[nodiscard]] std::optional<double> find_number_entry(std::span<const std::string> comments,
                                                      std::string_view key,
                                                      std::string_view subject = {});

/// The parts of such a comment.
struct CommentEntry {
  std::string key;      ///< lower-case letters, digits and `_`
  std::string subject;  ///< empty where there is none
  std::string value;    ///< the rest of the line
};

/// Returns the parts of an entry of any key, nothing of another comment. The subject ends at the
/// first `] = `.
[[nodiscard]] std::optional<CommentEntry> parse_comment_entry(std::string_view comment);

}  // namespace microslip
