// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"

/// @file
/// What a file of OUTPUT4 is made of, as text and in binary. Internal to io.

namespace microslip {

/// What a matrix begins with.
struct Op4Header {
  std::int64_t columns = 0;
  std::int64_t rows = 0;  ///< below 0: strings of non-zeros have their row in an integer of its own
  std::int64_t form = 0;  ///< 1 square, 2 rectangular, 6 symmetric, …
  std::int64_t type = 0;  ///< 1, 2: real of single and double precision; 3, 4: complex
  std::string name;       ///< in capitals
};

/// What a column begins with.
struct Op4Column {
  std::int64_t column = 0;  ///< from 1; above the columns of the matrix: its end
  std::int64_t row = 0;     ///< of the first number; 0: strings of non-zeros follow
  std::int64_t words = 0;   ///< of the column
};

/// Reads the pieces one after another.
class Op4Source {
 public:
  virtual ~Op4Source() = default;
  /// The next matrix; none at the end of the file. @throws FormatError, as do all others.
  virtual std::optional<Op4Header> header() = 0;
  virtual Op4Column column() = 0;
  /// Integers before a string of non-zeros, one or two.
  virtual std::vector<std::int64_t> integers(std::size_t count) = 0;
  /// The numbers that so many words of the matrix hold, or that fill them where `dense`.
  virtual std::size_t numbers_in(std::int64_t words, bool dense) const = 0;
  virtual std::vector<double> numbers(std::size_t count) = 0;
  virtual void end_column() = 0;
  /// What is behind the last column.
  virtual void end_matrix() = 0;
  /// Where it is, for messages.
  [[nodiscard]] virtual TextPlace place() const = 0;
};

/// Text.
class Op4Text : public Op4Source {
 public:
  Op4Text(std::string_view text, std::string file)
      : text_(text), rest_(text), file_(std::move(file)) {}

  std::optional<Op4Header> header() override;
  Op4Column column() override;
  std::vector<std::int64_t> integers(std::size_t count) override;
  [[nodiscard]] std::size_t numbers_in(std::int64_t words, bool dense) const override;
  std::vector<double> numbers(std::size_t count) override;
  void end_column() override {}
  void end_matrix() override;
  [[nodiscard]] TextPlace place() const override { return {file_, number_, 0}; }

 private:
  bool next_line();
  std::string_view need_line();
  std::int64_t integer(std::size_t begin, std::size_t width) const;

  std::string_view text_;
  std::string_view rest_;
  std::string file_;
  std::string_view line_;
  std::size_t number_ = 0;  ///< of the line, from 1
  bool double_ = false;
  std::size_t per_line_ = 5;
  std::size_t width_ = 16;
};

/// Records of Fortran, each between two counts of its bytes.
class Op4Binary : public Op4Source {
 public:
  Op4Binary(std::string_view bytes, std::string file);

  std::optional<Op4Header> header() override;
  Op4Column column() override;
  std::vector<std::int64_t> integers(std::size_t count) override;
  [[nodiscard]] std::size_t numbers_in(std::int64_t words, bool dense) const override;
  std::vector<double> numbers(std::size_t count) override;
  void end_column() override;
  void end_matrix() override { end_record(); }
  [[nodiscard]] TextPlace place() const override { return {file_, 0, 0}; }

 private:
  template <class Number>
  Number take();
  std::int64_t integer() { return long_ ? take<std::int64_t>() : take<std::int32_t>(); }
  void begin_record();
  void end_record();
  [[noreturn]] void fail(std::string_view expected, const std::string& found) const;

  std::string_view bytes_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t record_end_ = 0;
  bool swapped_ = false;
  bool long_ = false;    ///< integers of 64 bits, and numbers so, too
  bool double_ = false;  ///< of the matrix
};

/// Whether bytes begin with the header of a text, or of a record.
[[nodiscard]] bool is_op4_text(std::string_view head);
[[nodiscard]] bool is_op4_binary(std::string_view head);

}  // namespace microslip
