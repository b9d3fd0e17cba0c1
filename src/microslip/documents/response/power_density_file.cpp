// SPDX-License-Identifier: MIT
#include "microslip/documents/response/power_density_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {

PowerDensity read_power_density(const std::string& path, const Dimension& of) {
  const CsvTable table(read_text(path), input_name(path));
  PowerDensity read{table.numbers("frequency", kFrequency),
                    table.numbers("density", of.power(2) / kFrequency)};
  try {
    read.check();
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", table.file(), error.name()));
  }
  return read;
}

}  // namespace microslip
