// SPDX-License-Identifier: MIT
#include "structure/beams.hpp"

#include <cmath>
#include <cstdint>

namespace microslip::testing {

Beam reference_beam(double tip_stiffness, bool sensor_masses) {
  Beam beam{.length = 0.583,
            .bending_stiffness = 2.07e11 * 0.04 * std::pow(0.005, 3) / 12.0,
            .mass_per_length = 7850.0 * 0.04 * 0.005,
            .tip_stiffness = tip_stiffness};
  if (sensor_masses) beam.masses = {{0.55, 0.03}, {0.35, 0.01}, {0.18, 0.01}};
  return beam;
}

Beam unit_beam(double tip_stiffness) {
  return {.length = 1.0,
          .bending_stiffness = 1.0,
          .mass_per_length = 1.0,
          .tip_stiffness = tip_stiffness};
}

Beam random_beam(std::uint64_t seed) {
  RandomStream random(seed, 1);
  Beam beam{.length = 0.1 + random.uniform(),
            .bending_stiffness = std::pow(10.0, 3.0 * random.uniform()),
            .mass_per_length = std::pow(10.0, 2.0 * random.uniform() - 1.0)};
  const double spring = 8.0 * random.uniform() - 2.0;
  beam.tip_stiffness = spring < -1.0 ? 0.0
                       : spring > 5.5
                           ? kInfinity
                           : std::pow(10.0, spring) * beam.bending_stiffness / beam.length;
  const auto masses = static_cast<int>(7.0 * random.uniform());
  for (int i = 0; i < masses; ++i) {
    beam.masses.push_back(
        {beam.length * random.uniform(),
         beam.mass_per_length * beam.length * std::pow(10.0, 5.0 * random.uniform() - 3.0)});
  }
  if (masses >= 2 && seed % 3 == 0) {
    const double step = 0.01 * random.uniform();
    beam.masses[1].position = beam.masses[0].position * (1.0 - step);
  }
  return beam;
}

}  // namespace microslip::testing
