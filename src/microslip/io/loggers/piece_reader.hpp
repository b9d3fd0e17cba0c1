// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/progress.hpp"
#include "microslip/io/bytes/input_stream.hpp"

namespace microslip {

/// The bytes of a file from the first to the last, in pieces that lie in one block of memory.
class PieceReader {
 public:
  /// @throws FileError  as InputStream, and where it is a pipe or a device, which has no size.
  PieceReader(const std::string& path, Progress progress);

  [[nodiscard]] const std::string& name() const { return stream_.name(); }
  /// Bytes taken so far.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  /// No more bytes than these follow.
  [[nodiscard]] std::size_t left() const { return size_ - offset_; }

  /// The next `size` bytes, valid until the next call.
  /// @throws FormatError  where fewer follow.
  [[nodiscard]] std::string_view take(std::size_t size);
  void skip(std::size_t size);
  /// The next `size` bytes, or those that are left, which stay to be taken; valid until the next
  /// call.
  [[nodiscard]] std::string_view peek(std::size_t size);

  /// A FormatError at the place where the reader is.
  [[noreturn]] void fail(std::string_view expected, std::string_view found,
                         std::string_view remedy = kDamaged) const;

  static constexpr std::string_view kDamaged = "The file is damaged; save or copy it again.";
  /// As many bytes of values are taken in one piece, so that they stay in a cache.
  static constexpr std::size_t kPiece = std::size_t{1} << 18U;

 private:
  void refill(std::size_t size);

  InputStream stream_;
  Progress progress_;
  std::size_t size_;
  std::size_t offset_ = 0;
  std::size_t next_report_ = 0;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what is not taken yet, in the buffer
};

/// Calls `use(bytes, rows)` for all of `rows` rows of `width` bytes, in pieces of whole rows.
template <class Use>
void take_rows(PieceReader& file, std::size_t rows, std::size_t width, const Use& use) {
  const std::size_t most = width < PieceReader::kPiece ? PieceReader::kPiece / width : 1;
  for (std::size_t done = 0; done < rows;) {
    const std::size_t count = rows - done < most ? rows - done : most;
    use(file.take(count * width).data(), count);
    done += count;
  }
}

}  // namespace microslip
