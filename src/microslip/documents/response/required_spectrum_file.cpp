// SPDX-License-Identifier: MIT
#include "microslip/documents/response/required_spectrum_file.hpp"

#include "microslip/documents/response/checked_table.hpp"

namespace microslip {

RequiredSpectrum read_required_spectrum(const std::string& path) {
  return read_checked_table(path, [](const CsvTable& table) {
    return RequiredSpectrum{table.numbers("frequency", kFrequency),
                            table.numbers("maximax", kAcceleration)};
  });
}

}  // namespace microslip
