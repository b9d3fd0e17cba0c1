// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/io/mat/mat5_format.hpp"

/// @file
/// Writing of MAT files of version 5. Internal to io.

namespace microslip {

class Mat5Array;

/// The fields of a struct, in their order; names of at most 31 bytes.
using Mat5Fields = std::vector<std::pair<std::string_view, Mat5Array>>;

/// An array as it is written: it holds texts and structure, and points to the numbers.
class Mat5Array {
 public:
  /// n × 1; complex where there is an imaginary part. The values must outlive the array.
  [[nodiscard]] static Mat5Array column(std::span<const double> real,
                                        std::span<const double> imaginary);
  [[nodiscard]] static Mat5Array number(double value);
  /// @throws InputError  naming `place`, where the text is not UTF-8.
  [[nodiscard]] static Mat5Array text(std::string_view utf8, const std::string& place);
  /// rows × columns, the elements column by column.
  [[nodiscard]] static Mat5Array cell(std::size_t rows, std::size_t columns,
                                      std::vector<Mat5Array> elements);
  /// 1 × n.
  /// @param elements  one at least; all have the same fields.
  /// @throws InputError  for a name of more than 31 bytes.
  [[nodiscard]] static Mat5Array row_of_structs(std::vector<Mat5Fields> elements);

  /// Of the content of the element, behind its tag.
  [[nodiscard]] std::size_t bytes(std::string_view name) const;

 private:
  friend class Mat5Output;

  mat5::Class class_ = mat5::kDoubleClass;
  std::array<std::size_t, 2> sizes_{0, 0};
  std::span<const double> real_;
  std::span<const double> imaginary_;
  std::optional<double> number_;
  std::string text_;  ///< bytes, as text_type_ has them
  mat5::Type text_type_ = mat5::kUtf8;
  std::vector<std::string_view> fields_;
  std::vector<Mat5Array> children_;
};

using Mat5Variable = std::pair<std::string, Mat5Array>;

/// Writes a file without the time in its heading: the same variables give the same bytes.
/// @throws InputError  for a variable of 2 GiB or more, which the format cannot hold.
/// @throws FileError   where the file cannot be written.
void write_mat5(const std::string& path, std::span<const Mat5Variable> variables);

}  // namespace microslip
