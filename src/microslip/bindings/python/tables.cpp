// SPDX-License-Identifier: MIT
#include "microslip/bindings/python/tables.hpp"

#include "microslip/base/units.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/io/tables/csv.hpp"

namespace py = pybind11;

namespace microslip::python {

py::dict columns_of(const std::string& table) {
  const CsvTable csv(table, "table");
  py::dict all;
  for (const CsvColumn& column : csv.columns()) {
    const auto unit = column.unit ? find_unit(*column.unit) : std::nullopt;
    if (!unit) {
      all[py::str(column.name)] = csv.text(column.name);
      continue;
    }
    const std::string header = column.name + " [" + *column.unit + "]";
    all[py::str(header)] = array_of(csv.numbers(column.name, unit->dimension));
  }
  return all;
}

}  // namespace microslip::python
