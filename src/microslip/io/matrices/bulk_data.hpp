// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {

/// Entries of the bulk data of Nastran: lines of ten fields of 8 columns, of six with 16 columns
/// for those between (`DMIG*`), or with commas between them; lines that begin with a blank, + or *
/// go on with the entry before. What follows a $ is a comment. Internal to io.
class BulkData {
 public:
  /// A field of an entry, without blanks around it; empty where there is none.
  struct Field {
    std::string_view text;
    std::size_t line = 0;    ///< from 1
    std::size_t column = 0;  ///< from 1
  };

  /// @param text  all of it, must outlive this object.
  /// @param file  its name, for messages.
  BulkData(std::string_view text, std::string_view file) : rest_(text), file_(file) {}

  /// Goes on to the next entry; false at the end.
  bool next();
  /// Its name, in capitals and without a star: "DMIG".
  [[nodiscard]] std::string_view name() const { return name_; }
  /// The data field number i, from 0; an empty one behind the last.
  [[nodiscard]] Field field(std::size_t i) const;
  /// How many data fields its lines have.
  [[nodiscard]] std::size_t size() const { return fields_.size(); }

  /// The field as an integer. @throws FormatError  naming `what`.
  [[nodiscard]] std::int64_t integer(std::size_t i, std::string_view what) const;
  /// The field as a finite number: `1.5`, `1.5E+3`, `1.5D3` or `1.5+3`. @throws FormatError
  [[nodiscard]] double number(std::size_t i, std::string_view what) const;
  /// Of a field, or of the entry where it is not there.
  [[nodiscard]] TextPlace place(const Field& field) const;

 private:
  bool next_line();
  void take(std::string_view line);
  void take_columns(std::string_view line, std::size_t width, std::size_t count);
  void take_between_commas(std::string_view line);

  std::string_view rest_;
  std::string_view file_;
  std::string_view line_;  // without comment, not blank; the first that is not taken yet
  std::size_t number_ = 0;
  std::size_t first_line_ = 0;  // of the entry
  std::string name_;
  std::vector<Field> fields_;
};

}  // namespace microslip
