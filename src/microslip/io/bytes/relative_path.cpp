// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/relative_path.hpp"

#include <filesystem>

namespace microslip {

std::string path_from(const std::string& other, const std::string& from) {
  namespace fs = std::filesystem;
  if (fs::path(other).is_absolute() || from == "-") return other;
  const fs::path folder = fs::path(from).parent_path();
  const fs::path relative = fs::relative(other, folder.empty() ? "." : folder);
  return relative.empty() ? fs::absolute(other).string() : relative.string();
}

}  // namespace microslip
