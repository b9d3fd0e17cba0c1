// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/io/file_descriptor.hpp"

/// @file
/// Writing of a file from front to back. Internal to io.

namespace microslip {

class UffOutput {
 public:
  /// Opens the file, which becomes empty. @throws FileError  where it cannot be opened.
  explicit UffOutput(const std::string& path);

  /// @throws FileError  where the system does not take the bytes.
  void write(std::string_view bytes);

  /// @throws FileError  where the system reports, only now, that something could not be written.
  void close();

 private:
  [[noreturn]] void fail(int error) const;

  std::string path_;
  FileDescriptor file_;
};

}  // namespace microslip
