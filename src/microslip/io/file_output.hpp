// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/io/file_descriptor.hpp"

/// @file
/// Writing of a file from front to back. Internal to io.

namespace microslip {

class FileOutput {
 public:
  /// Opens the file, which becomes empty. @throws FileError  where it cannot be opened.
  explicit FileOutput(const std::string& path);

  /// @throws WriteError  where the system does not take the bytes.
  void write(std::string_view bytes);

  /// @throws WriteError  where the system reports, only now, that something could not be written.
  void close();

 private:
  std::string path_;
  FileDescriptor file_;
};

/// All of the bytes. @throws WriteError  naming `path`, where the system does not take them.
void write_all(int descriptor, std::string_view bytes, std::string_view path);

}  // namespace microslip
