// SPDX-License-Identifier: MIT
#include "microslip/documents/response/power_density_file.hpp"

#include "microslip/documents/response/checked_table.hpp"

namespace microslip {

PowerDensity read_power_density(const std::string& path, const Dimension& of) {
  return read_checked_table(path, [&](const CsvTable& table) {
    return PowerDensity{table.numbers("frequency", kFrequency),
                        table.numbers("density", of.power(2) / kFrequency)};
  });
}

}  // namespace microslip
