// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "microslip/base/random.hpp"
#include "microslip/structure/beam.hpp"

namespace microslip::testing {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The beam of tests/data/beam_modes.csv: steel, 583 mm × 40 mm × 5 mm, with its three sensors.
inline Beam reference_beam(double tip_stiffness, bool sensor_masses) {
  Beam beam{.length = 0.583,
            .bending_stiffness = 2.07e11 * 0.04 * std::pow(0.005, 3) / 12.0,
            .mass_per_length = 7850.0 * 0.04 * 0.005,
            .tip_stiffness = tip_stiffness};
  if (sensor_masses) beam.masses = {{0.55, 0.03}, {0.35, 0.01}, {0.18, 0.01}};
  return beam;
}

/// EI = ρA = L = 1: λ is the root of ω.
inline Beam unit_beam(double tip_stiffness) {
  return {.length = 1.0,
          .bending_stiffness = 1.0,
          .mass_per_length = 1.0,
          .tip_stiffness = tip_stiffness};
}

/// Springs from 0 to 10⁶ EI/L and infinity, 0 to 6 masses from 10⁻³ to 100 times that of the beam;
/// in every third beam two masses lie closer than 1 % of L.
inline Beam random_beam(std::uint64_t seed) {
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
