// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {

/// Lines of numbers between blanks, as programs write matrices. Fast: files have millions of lines.
/// Internal to io.
class NumberLines {
 public:
  /// @param text  all of it, must outlive this object.
  /// @param file  its name, for messages.
  NumberLines(std::string_view text, std::string_view file) : rest_(text), file_(file) {}

  /// Goes on to the next line that is not blank; false at the end.
  bool next();
  /// The line, without its end.
  [[nodiscard]] std::string_view line() const { return line_; }
  /// Bytes behind the line.
  [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }
  /// Of the field taken last, or of the line.
  [[nodiscard]] TextPlace place() const;

  /// The next field of the line, an integer. @throws FormatError  naming `what`.
  std::int64_t integer(std::string_view what);
  /// The next field, an index that counts from 1, as one that counts from 0.
  /// @throws FormatError  where it is not from 1 to `size`, with a word on those that count from 0.
  std::int32_t index(std::string_view what, std::size_t size);
  /// The next field, a finite number. @throws FormatError
  double number(std::string_view what);
  /// @throws FormatError  where the line has another field.
  void end();

 private:
  std::string_view field();
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;

  std::string_view rest_;
  std::string_view file_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::size_t at_ = 0;     ///< in the line
  std::size_t field_ = 0;  ///< where the field taken last begins
};

}  // namespace microslip
