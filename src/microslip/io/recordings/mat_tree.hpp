// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/io/recordings/whole_times.hpp"

/// @file
/// Contents of a MAT file of any version.

namespace microslip {

/// A value of MATLAB. Arrays are stored column by column, as there.
struct MatValue {
  enum class Kind { kNumbers, kSparse, kText, kCell, kStruct, kOther, kNotRead };

  Kind kind = Kind::kNotRead;
  std::vector<std::size_t> sizes;  ///< the length along each dimension
  std::vector<double> real;        ///< kNumbers, kSparse; integers beyond 2^53 are rounded
  std::vector<double> imaginary;   ///< of the same length, or empty: real numbers
  /// kNumbers: all digits of integers of eight bytes where one is beyond 2^53, as times since 1970;
  /// else empty.
  WholeNumbers whole = {};
  /// kSparse: the row of each number, from 0, and where the numbers of each column begin, with one
  /// more at the end. checked_sparse() has seen that they fit.
  std::vector<std::int64_t> row;
  std::vector<std::int64_t> column_start;
  std::vector<std::string> texts;   ///< kText: UTF-8, one per row
  std::vector<std::string> fields;  ///< kStruct: the names
  /// kStruct: the names are in the order of the program that wrote them. HDF5 keeps none.
  bool in_order = true;
  /// kCell: the elements. kStruct: the fields of the first element, then those of the second, ….
  std::vector<MatValue> children;
  std::string other;  ///< kOther: what it is, in words

  /// The product of the sizes.
  [[nodiscard]] std::size_t count() const;
  /// At most one size is not 1.
  [[nodiscard]] bool is_vector() const;
};

/// "a struct of 1 × 8 with the fields 'a', 'b'".
[[nodiscard]] std::string describe(const MatValue& value);

/// Of the matrix of kSparse: what does not fit, such as "a row 7 of 4"; empty where all does.
/// Numbers beyond the last column are unused space of the writer, and are removed.
[[nodiscard]] std::string checked_sparse(MatValue& value);

/// The points of a range of Octave: base, base + increment, … up to the limit; nothing where they
/// are not numbers, or more than `most`.
[[nodiscard]] std::optional<MatValue> octave_range(double base, double limit, double increment,
                                                   std::size_t most);

/// What stands for a range that octave_range() does not give.
[[nodiscard]] MatValue long_range(double base, double limit, double increment);

/// The array of structs of which `columns`, a struct of one element, has a cell for each field, as
/// Octave stores it; nothing where it has none or they differ in size.
[[nodiscard]] std::optional<MatValue> structs_of_columns(MatValue columns);

/// What a value of a class is called that only MATLAB itself reads: "an object of the class
/// 'timetable'".
[[nodiscard]] std::string other_class(std::string_view name);

/// The variables of a file, as a struct of one element.
struct MatTree {
  MatValue root;
  bool truncated = false;  ///< the file ends within the last variable, which is left out
};

struct MatReadOptions {
  /// Read this variable alone, the others are kNotRead; without it all are read.
  std::optional<std::string_view> only = {};
  bool allow_truncated = false;
  Progress progress = {};
};

/// Values of one file may not be more than these, nor nested deeper: no measurement is, and a
/// damaged file must not exhaust the memory.
inline constexpr std::size_t kMostMatValues = 1'000'000;
inline constexpr int kDeepestMatValue = 64;

}  // namespace microslip
