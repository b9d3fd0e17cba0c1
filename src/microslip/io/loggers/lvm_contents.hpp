// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/recordings/even_axis.hpp"

/// @file
/// Contents of LVM files of LabVIEW [NI, "Specification for the LabVIEW Measurement File"].
/// Internal to io/loggers.
///
/// A header of the file, then sections: a header, a line with the names of the columns and rows of
/// values to a blank line. Headers are lines of a tag and its entries.

namespace microslip {

/// A column of numbers. What is missing is not a number, but for the end of the column.
struct LvmColumn {
  std::string name;
  std::vector<double> values = {};
  PrintedDigits digits = {};
};

struct LvmChannel {
  LvmColumn column;
  std::size_t number = 0;  ///< of its column in the file, from 1
  std::size_t cell = 0;    ///< where in each line of the header its entry stands
  std::size_t x = 0;       ///< which of the columns of x is its own
};

using LvmHeader = std::map<std::string, std::vector<std::string>, std::less<>>;

struct LvmSection {
  LvmHeader header = {};          ///< entries by tag, that of the first column at 0
  std::vector<LvmColumn> x = {};  ///< none where the file has no columns of x
  std::vector<LvmChannel> channels = {};
  std::size_t line = 0;  ///< of its names

  /// The entry of a channel; empty where there is none for it.
  [[nodiscard]] std::string_view entry(std::string_view tag, const LvmChannel& channel) const;
};

struct LvmContents {
  std::vector<LvmSection> sections;
  bool comma = false;               ///< decimal commas
  bool has_absolute_times = false;  ///< x count from the same moment for all channels
};

/// A number as the file has it, with a decimal point or comma; nothing where it is none.
[[nodiscard]] std::optional<double> lvm_number(std::string_view text, bool comma);

/// @param path  for messages.
/// @throws FormatError  where the text is not of the form.
[[nodiscard]] LvmContents parse_lvm(std::string_view text, const std::string& path);

}  // namespace microslip
