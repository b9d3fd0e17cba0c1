// SPDX-License-Identifier: MIT
#include "microslip/documents/response/required_spectrum_file.hpp"

#include <fmt/format.h>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {

RequiredSpectrum read_required_spectrum(const std::string& path) {
  const CsvTable table(read_text(path), input_name(path));
  RequiredSpectrum read{table.numbers("frequency", kFrequency),
                        table.numbers("maximax", kAcceleration)};
  try {
    read.check();
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", table.file(), error.name()));
  }
  return read;
}

}  // namespace microslip
