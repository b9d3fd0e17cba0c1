// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/io/bytes/file_descriptor.hpp"

/// @file
/// Writing of a file from front to back. Internal to io.

namespace microslip {

/// As messages call it.
inline constexpr std::string_view kStandardOutput = "standard output";

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

/// The same on standard output, behind what stdio holds for it.
void write_standard_output(std::string_view bytes);

/// Brings standard output to the disk, for some file systems tell only then what they could not
/// keep.
/// @throws WriteError  where something got lost.
void finish_standard_output();

}  // namespace microslip
