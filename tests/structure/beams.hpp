// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "microslip/base/random.hpp"
#include "microslip/structure/beam.hpp"

namespace microslip::testing {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The beam of tests/data/beam_modes.csv: steel, 583 mm × 40 mm × 5 mm, with its three sensors.
Beam reference_beam(double tip_stiffness, bool sensor_masses);

/// EI = ρA = L = 1: λ is the root of ω.
Beam unit_beam(double tip_stiffness);

/// Springs from 0 to 10⁶ EI/L and infinity, 0 to 6 masses from 10⁻³ to 100 times that of the beam;
/// in every third beam two masses lie closer than 1 % of L.
Beam random_beam(std::uint64_t seed);

}  // namespace microslip::testing
