// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"

/// @file
/// The fixed-width fields of universal files. Internal to io.

namespace microslip {

/// Text as UTF-8: bytes that are no UTF-8 are taken for CP1252 (Latin-1 with more letters); control
/// characters become blanks.
[[nodiscard]] std::string uff_text(std::string_view bytes);

/// Whether a text field says nothing: blank, or NONE in any case.
[[nodiscard]] bool uff_is_none(std::string_view text);

/// A number as Fortran writes it, blanks around it allowed: exponents E, e, D, d, of any number of
/// digits, or without a letter ("1.5-105"). What is too small for a double is 0.
[[nodiscard]] std::optional<double> uff_number(std::string_view text);

/// Unit that columns of a line in UTF-8 count: Fortran pads text by characters, C and C++ by bytes.
/// In other character sets it is the same.
enum class UffCount { kCharacters, kBytes };

/// A field of a record's form.
struct UffField {
  enum Kind { kBlank, kInteger, kText };
  Kind kind;
  std::size_t width;
};

/// How the columns of a line count.
struct UffColumns {
  UffCount count = UffCount::kCharacters;
  bool certain = true;  ///< false: the other is as likely
};

/// The unit by which blanks and integers are where the form has them. Where that is so, or not so,
/// by both, a line of 80 bytes or characters tells; otherwise characters are taken, uncertainly.
[[nodiscard]] UffColumns uff_columns(std::string_view line, std::span<const UffField> form);

/// One line, taken field by field.
class UffFields {
 public:
  /// @param place  of the line.
  /// @param count  of what a field has so many; bytes where the line is not UTF-8.
  UffFields(std::string_view line, TextPlace place, UffCount count = UffCount::kCharacters);

  void skip(std::size_t width) { (void)take(width); }
  /// Without blanks around it; empty where it is none (uff_is_none()).
  [[nodiscard]] std::string text(std::size_t width);
  /// 0 where the field is blank. @throws FormatError  where it is no integer.
  [[nodiscard]] std::int64_t integer(std::size_t width, std::string_view what);
  /// 0 where the field is blank. @throws FormatError  where it is no finite number.
  [[nodiscard]] double number(std::size_t width, std::string_view what);

 private:
  std::string_view take(std::size_t width);
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;

  std::string line_;
  std::string_view rest_;
  TextPlace place_;
  UffCount count_;
  std::size_t column_ = 1;  ///< of the field taken last
  std::size_t next_column_ = 1;
};

/// Appends the numbers of a line of values. The widths are those of its fields, over and over.
/// Where the line does not fit them, its numbers are taken to stand between blanks.
/// @param whole  the line has its line break. A file that ends in a line may have cut a number:
///               then the last one counts only where it fills its field.
/// @throws FormatError  where something else than numbers stands there.
void append_uff_numbers(std::string_view line, std::span<const std::size_t> widths, bool whole,
                        const TextPlace& place, std::vector<double>& numbers);

/// The text with blanks behind it, or cut, to be so many characters wide; control characters become
/// blanks.
[[nodiscard]] std::string uff_padded(std::string_view text, std::size_t width);

/// The number of characters of a text in UTF-8.
[[nodiscard]] std::size_t uff_width(std::string_view text);

}  // namespace microslip
