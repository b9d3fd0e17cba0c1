// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/path_file.hpp"

#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/tables/column_rules.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {

DisplacementPath parse_path(std::string text, std::string_view file) {
  const CsvTable table(std::move(text), file);
  DisplacementPath path{.displacement = table.numbers("displacement", kLength),
                        .normal_load = table.numbers_if_present("normal_load", kDimensionless)};
  require_non_negative(table, "normal_load", path.normal_load,
                       "It is the normal load over its nominal value; 0 means no contact.");
  return path;
}

DisplacementPath read_path(const std::string& path) {
  return parse_path(read_text(path), input_name(path));
}

CsvWriter loop_table(const DisplacementPath& path, std::span<const double> force) {
  CsvWriter writer;
  writer.add_numbers("displacement", kLength, path.displacement);
  if (!path.normal_load.empty()) {
    writer.add_numbers("normal_load", kDimensionless, path.normal_load);
  }
  writer.add_numbers("force", kForce, force);
  return writer;
}

}  // namespace microslip
