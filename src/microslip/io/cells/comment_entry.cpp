// SPDX-License-Identifier: MIT
#include "microslip/io/cells/comment_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

#include "microslip/io/cells/csv_cells.hpp"

namespace microslip {
namespace {

std::string entry_start(std::string_view key, std::string_view subject) {
  if (subject.empty()) return fmt::format("{} = ", key);
  return fmt::format("{}[{}] = ", key, on_one_line(subject));
}

bool is_of_key(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

std::string comment_entry(std::string_view key, std::string_view subject, std::string_view value) {
  return entry_start(key, subject) + on_one_line(value);
}

std::optional<std::string> find_entry(std::span<const std::string> comments, std::string_view key,
                                      std::string_view subject) {
  const std::string start = entry_start(key, subject);
  for (const std::string& comment : comments) {
    if (comment.starts_with(start)) return comment.substr(start.size());
  }
  return std::nullopt;
}

std::optional<double> find_number_entry(std::span<const std::string> comments, std::string_view key,
                                        std::string_view subject) {
  const std::string start = entry_start(key, subject);
  for (const std::string& comment : comments) {
    if (!comment.starts_with(start)) continue;
    double value = 0.0;
    const char* const end = comment.data() + comment.size();
    const auto [stop, error] = std::from_chars(comment.data() + start.size(), end, value);
    if (error == std::errc() && stop == end) return value;
  }
  return std::nullopt;
}

std::optional<CommentEntry> parse_comment_entry(std::string_view comment) {
  constexpr std::string_view kEquals = " = ";
  constexpr std::string_view kCloses = "] = ";
  const auto end = std::ranges::find_if_not(comment, is_of_key);
  if (end == comment.begin()) return std::nullopt;
  const std::string key(comment.begin(), end);
  comment.remove_prefix(key.size());
  if (comment.starts_with(kEquals)) {
    return CommentEntry{key, {}, std::string(comment.substr(kEquals.size()))};
  }
  const std::size_t closed = comment.find(kCloses);
  if (!comment.starts_with('[') || closed == std::string_view::npos) return std::nullopt;
  return CommentEntry{key, std::string(comment.substr(1, closed - 1)),
                      std::string(comment.substr(closed + kCloses.size()))};
}

}  // namespace microslip
