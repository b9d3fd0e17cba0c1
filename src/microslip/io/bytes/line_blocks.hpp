// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "microslip/io/bytes/input_stream.hpp"

namespace microslip {

/// A long text in pieces of whole lines, so that it need not be in memory as a whole. Only the last
/// piece may end without a line break.
class LineBlocks {
 public:
  /// @param file  read on from where it stands; outlives this object.
  explicit LineBlocks(InputStream& file);

  /// Goes on to the next piece; false at the end.
  /// @throws FormatError  where a line is longer than 16 MiB, or than a block and has a byte 0x00:
  ///                      that is no text.
  bool next();

  /// Valid until next().
  [[nodiscard]] std::string_view text() const { return {buffer_.data(), size_}; }
  /// The same, to be changed in place and put right again.
  [[nodiscard]] std::span<char> writable_text() { return {buffer_.data(), size_}; }
  /// The number of its first line, from 1.
  [[nodiscard]] std::size_t first_line() const { return first_line_; }
  /// Bytes of this piece and those before it.
  [[nodiscard]] std::size_t bytes_done() const { return bytes_done_; }

 private:
  void check_text() const;
  void drop_text();
  std::size_t whole_lines() const;

  InputStream& file_;
  std::string buffer_;      ///< the piece, then the beginning of the next one
  std::size_t size_ = 0;    ///< of the piece
  std::size_t filled_ = 0;  ///< of the buffer
  std::size_t first_line_ = 1;
  std::size_t bytes_done_ = 0;
};

}  // namespace microslip
