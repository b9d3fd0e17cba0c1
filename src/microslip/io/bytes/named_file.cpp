// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/named_file.hpp"

#include <filesystem>
#include <system_error>

#include "microslip/base/error.hpp"

namespace microslip {

namespace fs = std::filesystem;

std::string file_beside(const std::string& naming, const std::string& name) {
  std::string path = (fs::path(naming).parent_path() / name).string();
  check_named_file(path);
  return path;
}

void check_named_file(const std::string& path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (unknown || !fs::exists(status) || fs::is_directory(status) || fs::is_regular_file(status)) {
    return;
  }
  throw FileError(path, "is a pipe or a device, and named in another file",
                  "Save what it gives in a regular file; only a call itself may name pipes.");
}

}  // namespace microslip
