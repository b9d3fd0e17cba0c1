// SPDX-License-Identifier: MIT
#include "microslip/structure/uniform_beam.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// Above it squares of shear forces leave the range of a double.
constexpr double kLargestMass = 1e50;  // over that of the beam

void require_positive(std::string_view name, double value) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw InputError(name, value, "must be positive and finite");
  }
}

}  // namespace

void check_beam(const Beam& beam) {
  require_positive("length", beam.length);
  require_positive("bending_stiffness", beam.bending_stiffness);
  require_positive("mass_per_length", beam.mass_per_length);
  if (!(beam.tip_stiffness >= 0.0)) {
    throw InputError("tip_stiffness", beam.tip_stiffness, "must be 0 or more",
                     "0 is a pinned end, infinity a clamped one.");
  }
  for (std::size_t i = 0; i < beam.masses.size(); ++i) {
    const auto [position, mass] = beam.masses[i];
    if (!(position >= 0.0 && position <= beam.length)) {
      throw InputError(fmt::format("masses[{}].position", i), position,
                       fmt::format("must be on the beam, from 0 to {} m", beam.length));
    }
    if (!(mass >= 0.0 && mass <= kLargestMass * beam.mass_per_length * beam.length)) {
      throw InputError(fmt::format("masses[{}].mass", i), mass,
                       fmt::format("must be 0 or more, and at most {} times the mass of the beam",
                                   kLargestMass));
    }
  }
}

}  // namespace microslip
