// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"

/// @file
/// The bytes of a universal file, taken from front to back by lines and by blocks. Internal to io.

namespace microslip {

class UffInput {
 public:
  /// A regular file is read piece by piece; what comes through a pipe is kept in memory.
  /// @param progress  called with the bytes done of all bytes, every few megabytes.
  /// @throws FileError  as read_file().
  explicit UffInput(const std::string& path, Progress progress = {});

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t remaining() const { return size_ - position_; }

  /// The next line without its LF or CRLF, or what is left where no line break follows; nothing at
  /// the end of the file. It stays valid until the next call of any function. Of a line longer than
  /// any of a universal file only the beginning is given.
  std::optional<std::string_view> line();

  /// Whether the last line ended with a line break, not with the file.
  [[nodiscard]] bool line_was_whole() const { return line_was_whole_; }

  /// The last line, for messages. Behind binary values lines have no numbers.
  [[nodiscard]] TextPlace place(std::size_t column = 0) const;

  /// Fills the span with the next bytes, of which there must be so many.
  void read(std::span<char> bytes);

  /// At most `size` bytes from `offset` bytes ahead on; the position stays.
  [[nodiscard]] std::string peek(std::size_t offset, std::size_t size);

 private:
  std::string_view window(std::size_t size);
  void copy(std::size_t from, std::span<char> bytes) const;
  void report(std::size_t done);

  std::string name_;
  Progress progress_;
  FileDescriptor file_;
  std::string content_;  ///< of a pipe
  bool in_memory_ = false;
  std::size_t size_ = 0;
  std::size_t position_ = 0;
  std::string window_;  ///< a piece of the file
  std::size_t window_start_ = 0;
  std::size_t line_number_ = 0;
  bool lines_are_counted_ = true;
  bool line_was_whole_ = true;
  std::size_t reported_ = 0;
};

}  // namespace microslip
