// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/table_cells.hpp"

#include <charconv>
#include <cstddef>
#include <limits>
#include <system_error>

#include "microslip/io/tables/csv.hpp"

namespace microslip {

std::vector<double> numbers_or_empty(const CsvTable& table, const std::string& name) {
  std::vector<double> numbers;
  const std::vector<std::string> cells = table.text(name);
  for (std::size_t row = 0; row < cells.size(); ++row) {
    double number = std::numeric_limits<double>::quiet_NaN();
    const char* const end = cells[row].data() + cells[row].size();
    const auto [rest, error] = std::from_chars(cells[row].data(), end, number);
    if (!cells[row].empty() && (error != std::errc() || rest != end)) {
      table.reject(row, name, "a number, or nothing");
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::pair<std::string, std::string> name_and_unit(const std::string& text) {
  const std::size_t bracket = text.find(" [");
  if (bracket == std::string::npos || !text.ends_with(']')) return {text, ""};
  return {text.substr(0, bracket), text.substr(bracket + 2, text.size() - bracket - 3)};
}

}  // namespace microslip
