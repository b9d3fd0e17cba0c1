// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/density_file.hpp"

#include <cstddef>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/tables/column_rules.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {
namespace {

void check_band(const CsvTable& table, const DensityTable& density) {
  require_non_negative(table, "lower", density.lower);
  for (std::size_t row = 0; row < density.upper.size(); ++row) {
    if (!(density.upper[row] >= density.lower[row])) {
      table.reject(row, "upper", "a number not below that of 'lower'", "Are the two swapped?");
    }
  }
}

}  // namespace

DensityTable parse_density(std::string text, std::string_view file) {
  const CsvTable table(std::move(text), file);
  DensityTable density;
  density.slip_force = table.numbers("slip_force", kForce);
  density.density = table.numbers("density", kPerForce);
  if (table.has("lower") || table.has("upper")) {
    density.lower = table.numbers("lower", kPerForce);
    density.upper = table.numbers("upper", kPerForce);
  }
  require_non_negative(table, "slip_force", density.slip_force);
  require_rising(table, "slip_force", density.slip_force, "Sort the rows by slip force.");
  require_non_negative(table, "density", density.density,
                       "A slip-force density cannot be negative.");
  check_band(table, density);
  return density;
}

DensityTable read_density(const std::string& path) {
  return parse_density(read_text(path), input_name(path));
}

CsvWriter density_table(const DensityTable& density) {
  CsvWriter writer;
  writer.add_numbers("slip_force", kForce, density.slip_force);
  writer.add_numbers("density", kPerForce, density.density);
  if (!density.lower.empty() || !density.upper.empty()) {
    writer.add_numbers("lower", kPerForce, density.lower);
    writer.add_numbers("upper", kPerForce, density.upper);
  }
  return writer;
}

}  // namespace microslip
