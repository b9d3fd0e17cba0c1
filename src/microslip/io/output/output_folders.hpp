// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/output/temporaries.hpp"

namespace microslip {

/// Folders for files to come. Those that had to be made are removed again, at destruction or by
/// remove_temporaries(), where nothing came into them: a computation that is refused, cancelled or
/// interrupted leaves no empty folder behind.
class OutputFolders {
 public:
  OutputFolders() = default;
  OutputFolders(const OutputFolders&) = delete;
  OutputFolders& operator=(const OutputFolders&) = delete;
  ~OutputFolders();

  /// Makes a folder and those above it where they are missing.
  /// @param path    of the folder.
  /// @param remedy  of the message.
  /// @throws FileError  where that fails or a file has the name.
  void make(const std::string& path, std::string_view remedy = "Choose another folder.");

 private:
  std::vector<Temporary> made_;  // the outer ones first
};

}  // namespace microslip
