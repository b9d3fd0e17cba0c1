// SPDX-License-Identifier: MIT
#include "microslip/io/tables/column_rules.hpp"

#include <cstddef>

namespace microslip {

void require_positive(const CsvTable& table, std::string_view name, std::span<const double> values,
                      std::string_view remedy) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(values[row] > 0.0)) table.reject(row, name, "a number above 0", remedy);
  }
}

void require_non_negative(const CsvTable& table, std::string_view name,
                          std::span<const double> values, std::string_view remedy) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(values[row] >= 0.0)) table.reject(row, name, "a number of 0 or more", remedy);
  }
}

void require_rising(const CsvTable& table, std::string_view name, std::span<const double> values,
                    std::string_view remedy) {
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (!(values[row] >= values[row - 1])) {
      table.reject(row, name, "a number not below that of the row before it", remedy);
    }
  }
}

}  // namespace microslip
