// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/distinct_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

/// A variable with the numbers of its elements as MATLAB counts them: "data[1]" is "data(2)".
std::string counted_from_one(std::string_view variable) {
  std::string text;
  while (!variable.empty()) {
    const std::size_t open = std::min(variable.find_first_of("([{"), variable.size());
    text += variable.substr(0, open);
    variable.remove_prefix(open);
    std::size_t number = 0;
    const char* const begin = variable.data() + std::min<std::size_t>(1, variable.size());
    const auto [end, error] = std::from_chars(begin, variable.data() + variable.size(), number);
    if (variable.empty() || error != std::errc() || end == variable.data() + variable.size()) {
      return text.append(variable);
    }
    text += fmt::format("({})", number + (variable.front() == '[' ? 1 : 0));
    variable.remove_prefix(static_cast<std::size_t>(end - variable.data()) + 1);
  }
  return text;
}

/// Whether the second is the first, or a part of it: "data(2).force" of "data".
bool holds(std::string_view whole, std::string_view part) {
  if (!part.starts_with(whole)) return false;
  return whole.empty() || part.size() == whole.size() ||
         std::string_view(".([{").find(part[whole.size()]) != std::string_view::npos;
}

}  // namespace

std::optional<std::string> same_file(std::span<const std::string> before, const std::string& path) {
  const PartOfFile part = part_of_file(path);
  const std::string variable = counted_from_one(part.variable);
  for (const std::string& other : before) {
    const PartOfFile of_other = part_of_file(other);
    const std::string other_variable = counted_from_one(of_other.variable);
    std::error_code none;  // a missing file is reported by its reader
    if ((holds(variable, other_variable) || holds(other_variable, variable)) &&
        std::filesystem::equivalent(of_other.file, part.file, none)) {
      return other;
    }
  }
  return std::nullopt;
}

void check_distinct_files(std::span<const std::string> paths) {
  for (std::size_t i = 1; i < paths.size(); ++i) {
    const std::optional<std::string> other = same_file(paths.first(i), paths[i]);
    if (!other) continue;
    const bool in_parts = part_of_file(paths[i]).variable != part_of_file(*other).variable;
    throw InputError(input_name(paths[i]),
                     fmt::format("{} as {}", in_parts ? "in part the same" : "the same file",
                                 input_name(*other)),
                     "must be given only once, or it counts twice", "Leave one of them out.");
  }
}

std::vector<Warning> same_content_warnings(std::span<const InputHash> files,
                                           std::string_view what) {
  std::vector<Warning> warnings;
  const auto is_whole = [](const InputHash& file) {
    return !file.sha256.empty() && part_of_file(file.file).variable.empty();
  };
  for (std::size_t i = 1; i < files.size(); ++i) {
    if (!is_whole(files[i])) continue;
    const auto before = files.first(i);
    const auto same = std::ranges::find_if(before, [&](const InputHash& other) {
      return is_whole(other) && other.sha256 == files[i].sha256;
    });
    if (same == before.end()) continue;
    warnings.push_back(
        {"same_content", fmt::format("{} has the same content as {}: {} counts twice.",
                                     printable(input_name(files[i].file)),
                                     printable(input_name(same->file)), what)});
  }
  return warnings;
}

}  // namespace microslip
