// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/bytes/file_descriptor.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/temporaries.hpp"

namespace microslip {

/// A table that goes to disk row by row, whole or not at all, while what its comments say is known
/// only at the end. Rows gather in a temporary file; finish() puts the comments and the header
/// before them. On standard output the comments follow the rows. Memory does not grow with the
/// rows. Internal to io.
class TableStream {
 public:
  /// @param path    "-" is standard output, which gets heading and header at once.
  /// @param head    lines of comment that are known already, each with its end.
  /// @param header  the line of column names, with its end.
  /// @throws FileError  as OutputFiles.
  TableStream(std::string path, std::string head, std::string header);

  /// Adds text of rows, each with its end. @throws FileError  where it cannot be written.
  void add(std::string_view rows);

  /// Gives the file its name. @param comments  lines of comment, each with its end.
  /// @throws FileError  where it cannot be written or replaced.
  void finish(std::string_view comments);

 private:
  [[nodiscard]] bool on_standard_output() const { return path_ == "-"; }
  void flush();
  void copy_rows(int to);

  std::string path_;
  std::string head_;
  std::string header_;
  std::string buffer_;
  OutputFiles output_;
  std::string staged_;
  std::optional<Temporary> temporary_;  ///< of the rows
  std::optional<FileDescriptor> rows_;
};

}  // namespace microslip
