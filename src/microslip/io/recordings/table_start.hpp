// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// Rows of numbers without a line that could have their names.
struct UnnamedRows {
  std::size_t line = 0;   ///< of the first, from 1 on
  std::size_t cells = 0;  ///< of each
};

/// Where the header of a table begins in a text that may have lines of another kind above it, which
/// loggers and testing machines write without a mark: the line above the first two rows of numbers
/// of as many cells, or the one above that where the line between has the units; one more line
/// may stand between the two.
struct TableStart {
  std::vector<std::string_view> preamble;  ///< lines above the header, neither blank nor comments
  std::size_t header = 0;                  ///< offset of the header in the text
  std::size_t units = 0;                   ///< offset of the line of units, where one was found
  std::string_view names = {};             ///< the line of the header
  std::string_view below = {};             ///< the next one, which may have the units
  bool blanks = false;                     ///< whether blanks alone separate the columns
  bool counts = false;                     ///< whether its first cells count the rows
  bool gaps = false;                       ///< whether two blanks or more separate the names
  bool row_names = false;           ///< whether each row begins with a name of its own, in quotes
  std::string_view commented = {};  ///< names in a comment above rows without a header
  std::vector<bool> rising = {};    ///< by column, whether the first rows rise
  /// By column, the cell of the first row where it is no number, else empty.
  std::vector<std::string> texts = {};
  std::optional<UnnamedRows> unnamed = {};  ///< where no line can have the names
};

/// @param text  the beginning of the file, whole lines.
/// @return  no preamble where the header is the first line, or there are no such rows; no lines
///          where there are less than two.
[[nodiscard]] TableStart find_table_start(std::string_view text);

}  // namespace microslip
