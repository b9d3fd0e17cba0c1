// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/measured_levels.hpp"

#include <cstddef>

#include "microslip/base/units.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {

MeasuredLevels levels_of(const NamedInput& input) {
  const LevelsFile file = parse_levels(input.text, input.path);
  const CsvTable table(input.text, input.path);
  MeasuredLevels levels;
  levels.levels = file.levels;
  if (table.has("source")) levels.source = table.text("source");
  if (table.has("flags")) levels.flags = table.text("flags");
  levels.frequency = table.numbers_if_present("frequency", kFrequency);
  levels.resonance_frequency = table.numbers_if_present("resonance_frequency", kFrequency);
  levels.force_amplitude = table.numbers_if_present("force_amplitude", kForce);
  levels.response_amplitude = table.numbers_if_present("response_amplitude", kAcceleration);
  levels.input_energy = table.numbers_if_present("input_energy", kEnergy);
  levels.linear_dissipation = table.numbers_if_present("linear_dissipation", kEnergy);
  levels.force_distortion = table.numbers_if_present("force_distortion", kDimensionless);
  levels.damping_ratio = table.numbers_if_present("damping_ratio", kDimensionless);
  for (std::size_t i = 0; i < file.levels.size(); ++i) {
    levels.left_out.push_back(file.has_inner_reversals(i));
  }
  return levels;
}

}  // namespace microslip
