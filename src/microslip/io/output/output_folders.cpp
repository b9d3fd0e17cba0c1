// SPDX-License-Identifier: MIT
#include "microslip/io/output/output_folders.hpp"

#include <filesystem>
#include <system_error>

#include "microslip/io/output/write_error.hpp"

namespace microslip {

namespace fs = std::filesystem;

OutputFolders::~OutputFolders() {
  while (!made_.empty()) made_.pop_back();  // the inner ones first
}

void OutputFolders::make(const std::string& path, std::string_view remedy) {
  fs::path so_far;
  for (const fs::path& part : fs::path(path)) {
    so_far /= part;
    std::error_code error;
    if (fs::create_directory(so_far, error)) made_.emplace_back(so_far.string());
    if (!error) continue;
    const std::string where = so_far == path ? "" : so_far.string() + ": ";
    if (is_fault_of_path(error.value())) throw FileError(path, where + error.message(), remedy);
    throw WriteError(path, where + error.message(), remedy);
  }
}

}  // namespace microslip
