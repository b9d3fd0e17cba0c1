// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/io/uff/uff_fields.hpp"
#include "microslip/io/uff/uff_input.hpp"

/// @file
/// The datasets of a universal file: each between two lines of -1. Internal to io.

namespace microslip {

/// The file ends, or the dataset is closed, before all that must be there.
class UffTruncated : public FormatError {
 public:
  using FormatError::FormatError;
};

/// Whether the whole line is the one that opens and closes datasets: -1 in columns 5 and 6, blanks
/// behind it. The same bytes within a line or among binary values mean nothing.
[[nodiscard]] bool is_uff_marker(std::string_view line);

/// The line that says what a dataset is.
struct UffDataset {
  std::size_t ordinal = 0;  ///< from 1
  int number = 0;           ///< the type: 58
  bool binary = false;      ///< 58b
  std::string id_line;
};

class UffEnvelope {
 public:
  explicit UffEnvelope(UffInput& input) : input_(input) {}

  [[nodiscard]] UffInput& input() { return input_; }

  /// Opens the next dataset; nothing at the end of the file.
  /// @throws FormatError  where something else than a dataset follows.
  std::optional<UffDataset> next();

  /// The next line of the dataset that is open.
  /// @param what  stands there, for the message.
  /// @throws UffTruncated  where the file ends or the dataset is closed.
  std::string_view line(std::string_view what);

  /// The same, as fields.
  UffFields fields(std::string_view what);

  /// The next line of values, or nothing where the dataset is closed or the file ends; see
  /// closed().
  std::optional<std::string_view> value_line();

  /// Result of skipping the rest of a dataset.
  struct Rest {
    std::size_t lines = 0;  ///< not blank
    bool closed = false;    ///< false: the file ends without the closing line
  };
  Rest close();

  /// The number of datasets that were opened.
  [[nodiscard]] std::size_t count() const { return ordinal_; }

  /// "dataset 3": how messages call the one that is open.
  [[nodiscard]] std::string dataset_name() const;

 private:
  UffInput& input_;
  std::size_t ordinal_ = 0;
  bool closed_ = true;
};

}  // namespace microslip
