// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Single values out of MAT files of MATLAB, version 5 (compressed or not) and 7.3.
///
/// `variable` is a path as in MATLAB: `FRdata.ResponseControl(3).force`; `{3}` takes the third
/// element of a cell. Indices in ( ) and { } count from 1 and run through arrays column by column;
/// those in [ ] count from 0, as in Python: `FRdata.ResponseControl[2].force` is the same place.
///
/// All of these throw
///   FileError    where the file cannot be read,
///   FormatError  where it is no MAT file or is damaged,
///   InputError   where the variable is missing or is something else, naming what there is.

namespace microslip {

/// An array of numbers.
struct MatArray {
  std::vector<std::size_t> sizes;  ///< the length along each dimension, two at least
  std::vector<double> real;        ///< column by column
  std::vector<double> imaginary;   ///< of the same length, or empty: the numbers are real
};

class InputStream;
struct MatTree;

/// A variable of a file with all that is in it: the file is read once, whatever is asked for.
class MatVariable {
 public:
  /// @param path      of the file.
  /// @param variable  its name, or a path that begins with it; empty: none, but the names of
  ///                  all.
  MatVariable(std::string path, std::string_view variable);

  /// As above, of a file that is open, of which nothing was taken.
  MatVariable(InputStream& file, std::string_view variable);

  /// Of the file.
  [[nodiscard]] const std::string& path() const { return path_; }

  /// All numbers of a real array, column by column; of any numeric class.
  [[nodiscard]] std::vector<double> numbers(std::string_view variable) const;
  /// All numbers of an array, real or complex, with its sizes.
  [[nodiscard]] MatArray array(std::string_view variable) const;
  /// A text of one row, in UTF-8.
  [[nodiscard]] std::string text(std::string_view variable) const;
  /// The names of the fields of a struct; of the variables of the file where `variable` is empty.
  [[nodiscard]] std::vector<std::string> fields(std::string_view variable) const;
  /// The number of elements of an array of any kind.
  [[nodiscard]] std::size_t count(std::string_view variable) const;

 private:
  std::string path_;
  std::shared_ptr<MatTree> tree_;
};

/// MatVariable::numbers() of a file that is read for it alone.
[[nodiscard]] std::vector<double> read_mat_numbers(const std::string& path,
                                                   std::string_view variable);

/// MatVariable::array() of a file that is read for it alone.
[[nodiscard]] MatArray read_mat_array(const std::string& path, std::string_view variable);

/// MatVariable::text() of a file that is read for it alone.
[[nodiscard]] std::string read_mat_text(const std::string& path, std::string_view variable);

/// MatVariable::fields() of a file that is read for it alone.
[[nodiscard]] std::vector<std::string> mat_fields(const std::string& path,
                                                  std::string_view variable);

/// MatVariable::count() of a file that is read for it alone.
[[nodiscard]] std::size_t mat_count(const std::string& path, std::string_view variable);

}  // namespace microslip
