// SPDX-License-Identifier: MIT
#pragma once

#include <zlib.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/io/bytes/input_stream.hpp"

namespace microslip {

/// The bytes of a MAT file in their order.
class MatStream {
 public:
  /// The file ends before what it announces.
  class Ended : public FormatError {
   public:
    using FormatError::FormatError;
  };

  explicit MatStream(std::string name) : name_(std::move(name)) {}
  MatStream(const MatStream&) = delete;
  MatStream& operator=(const MatStream&) = delete;
  virtual ~MatStream() = default;

  /// Bytes taken so far.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  /// No more bytes than these can follow.
  [[nodiscard]] virtual std::size_t at_most() const = 0;

  /// @throws Ended, FormatError  where fewer bytes follow, or those that do are damaged.
  void read(char* to, std::size_t size);
  void skip(std::size_t size);

  /// The name and the place in it, for messages.
  [[nodiscard]] std::string label() const;

  /// A FormatError at the place where the stream is.
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;
  [[noreturn]] void fail_ended(std::string_view expected) const;

 protected:
  virtual std::size_t read_some(char* to, std::size_t size) = 0;

 private:
  std::string name_;
  std::size_t offset_ = 0;
};

class MatFileStream : public MatStream {
 public:
  /// @param file  of which nothing was taken; it outlives this.
  /// @throws FileError  where it is a pipe or a device.
  MatFileStream(InputStream& file, Progress progress);

  [[nodiscard]] std::size_t at_most() const override { return size_ - offset(); }
  [[nodiscard]] bool at_end() const { return offset() == size_; }

  /// The first bytes of the file, at most `size` of them, before any is read.
  [[nodiscard]] std::string head(std::size_t size);

 private:
  std::size_t read_some(char* to, std::size_t size) override;

  InputStream& file_;
  std::size_t size_ = 0;
  std::vector<char> ahead_ = {};  ///< read from the file, for the many small values
  std::size_t taken_ = 0;         ///< of these
  Progress progress_;
  std::size_t next_report_ = 0;
};

/// Contents of an element of a file, inflated (RFC 1950).
class MatInflateStream : public MatStream {
 public:
  /// @param compressed  bytes that the element has in the file.
  MatInflateStream(MatFileStream& file, std::size_t compressed);
  ~MatInflateStream() override { ::inflateEnd(&state_); }

  [[nodiscard]] std::size_t at_most() const override;

  /// Goes behind the compressed data, and checks the checksum of the whole.
  /// @param most  bytes that may follow those that were read.
  /// @throws FormatError  where more follow.
  void finish(std::size_t most);

 private:
  std::size_t read_some(char* to, std::size_t size) override;
  void refill();

  MatFileStream& file_;
  std::size_t compressed_;  ///< bytes not yet taken from the file
  bool ended_ = false;
  z_stream state_{};
  std::array<char, 65536> buffer_;
};

}  // namespace microslip
