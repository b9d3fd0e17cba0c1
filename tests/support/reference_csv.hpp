// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace microslip::testing {

/// Columns by their full name, unit included. `#` lines are comments. Deliberately not the reader
/// of the library, so that a reference is not read by the code under test.
class ReferenceTable {
 public:
  explicit ReferenceTable(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open " + path);
    std::vector<std::string> names;
    for (std::string line; std::getline(file, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.empty() || line.front() == '#') continue;
      const std::vector<std::string> cells = split(line);
      if (names.empty()) {
        names = cells;
        continue;
      }
      for (std::size_t i = 0; i < cells.size(); ++i) {
        columns_[names.at(i)].push_back(std::stod(cells[i]));
      }
      ++rows_;
    }
  }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] const std::vector<double>& operator[](const std::string& name) const {
    return columns_.at(name);
  }

 private:
  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
  }

  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

/// A file of tests/data.
inline ReferenceTable reference_table(const std::string& name) {
  return ReferenceTable(std::string(MICROSLIP_TEST_DATA) + "/" + name);
}

}  // namespace microslip::testing
