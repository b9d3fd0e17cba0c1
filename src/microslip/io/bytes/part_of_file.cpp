// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/part_of_file.hpp"

#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace microslip {

PartOfFile part_of_file(const std::string& path) {
  const auto is_there = [](const std::string& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
  };
  if (path == "-" || is_there(path)) return {path, {}};
  for (std::size_t i = path.rfind(':'); i != std::string::npos && i > 0;
       i = path.rfind(':', i - 1)) {
    std::string file = path.substr(0, i);
    if (is_there(file)) return {std::move(file), path.substr(i + 1)};
  }
  return {path, {}};
}

}  // namespace microslip
