// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace microslip {

/// A matrix, stored by rows.
struct PlainMatrix {
  std::size_t columns = 0;     ///< numbers in a row
  std::vector<double> values;  ///< rows × columns

  /// The number of rows.
  [[nodiscard]] std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
};

}  // namespace microslip
