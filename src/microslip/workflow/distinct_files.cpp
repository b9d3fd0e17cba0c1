// SPDX-License-Identifier: MIT
#include "microslip/workflow/distinct_files.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/recording_file.hpp"

namespace microslip {

std::optional<std::string> same_file(std::span<const std::string> before, const std::string& path) {
  const PartOfFile part = part_of_file(path);
  for (const std::string& other : before) {
    const PartOfFile of_other = part_of_file(other);
    std::error_code none;  // what is not there is missed by whoever reads it
    if (of_other.variable == part.variable &&
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
    throw InputError(input_name(paths[i]), fmt::format("the same file as {}", input_name(*other)),
                     "must be given once, or it counts twice", "Leave one of them out.");
  }
}

}  // namespace microslip
