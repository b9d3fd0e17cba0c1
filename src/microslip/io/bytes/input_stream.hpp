// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/io/bytes/file_descriptor.hpp"

namespace microslip {

/// The bytes of a file, or of standard input, from the first to the last.
class InputStream {
 public:
  /// @param path  "-" is standard input, read on from where it stands.
  /// @throws FileError  where it does not exist, is a folder or may not be read.
  explicit InputStream(const std::string& path);

  /// A text that has been read, as if it were the file.
  /// @param name  how messages call it.
  InputStream(std::string text, std::string name);

  /// How messages call it.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Its size as the system has it now, in bytes; nothing for pipes and devices.
  [[nodiscard]] std::optional<std::size_t> size() const { return size_; }

  /// Reads until `size` bytes are there or the file ends; returns how many are.
  /// @throws FileError  where the system reports a failure.
  std::size_t read(char* buffer, std::size_t size);

  /// The next bytes, at most `size` of them, which read() gives again. Valid until the next call.
  /// @throws FileError  as read().
  std::string_view peek(std::size_t size);

  /// Goes back to the byte where this stream began. False where that cannot be, as in a pipe.
  bool rewind();

 private:
  std::size_t read_file(char* buffer, std::size_t size);

  std::string name_;
  FileDescriptor file_;
  std::optional<std::size_t> size_;
  std::optional<std::size_t> begin_;
  std::string peeked_;
};

}  // namespace microslip
