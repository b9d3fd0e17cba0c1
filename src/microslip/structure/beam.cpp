// SPDX-License-Identifier: MIT
#include "microslip/structure/beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/structure/beam_modes.hpp"
#include "microslip/structure/beam_shooting.hpp"

namespace microslip {
namespace {

/// Above it an argument is a mistake rather than a beam; the work grows with λ.
constexpr double kLargestWavenumber = 1e4;
/// λ of the first mode is below this for every tip spring: 4.7300 of the clamped beam without
/// masses.
constexpr double kLargestFirstWavenumber = 4.74;
/// Rounding of the spring of a pinned beam, over EI/L; its static value is 4.
constexpr double kNoSpring = 1e-12;

/// Above it squares of shear forces leave the range of a double.
constexpr double kLargestMass = 1e50;  // over that of the beam

void require_positive(std::string_view name, double value) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw InputError(name, value, "must be positive and finite");
  }
}

double first_frequency_with(Beam beam, double tip_stiffness) {
  beam.tip_stiffness = tip_stiffness;
  return BeamModes(beam, 1).frequency(0);
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

std::size_t natural_frequencies_below(const Beam& beam, double angular_frequency) {
  check_beam(beam);
  const double lambda = wavenumber(beam, angular_frequency);
  if (!(angular_frequency >= 0.0 && lambda <= kLargestWavenumber)) {
    throw InputError("angular_frequency", angular_frequency,
                     fmt::format("must be from 0 to {:.6g} rad/s for this beam",
                                 microslip::angular_frequency(beam, kLargestWavenumber)));
  }
  if (lambda == 0.0) return 0;
  BeamShooting shooting(beam, lambda);
  shooting.march(lambda);
  return shooting.below();
}

double spring_for_first_frequency(const Beam& beam, double first_frequency) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  check_beam(beam);
  require_positive("first_frequency", first_frequency);
  Beam clamped = beam;
  clamped.tip_stiffness = kInfinity;
  const double lambda = wavenumber(beam, 2.0 * std::numbers::pi * first_frequency);
  if (lambda < kLargestFirstWavenumber) {
    BeamShooting shooting(clamped, lambda);
    shooting.march(lambda);
    const double spring = shooting.matching_spring();
    if (shooting.below() == 0 && spring >= -kNoSpring) {
      return std::max(spring, 0.0) * beam.bending_stiffness / beam.length;
    }
  }
  throw InputError(
      "first_frequency", first_frequency,
      fmt::format("must be at least {:.10g} Hz, that of the pinned beam, and below "
                  "{:.10g} Hz, that of the clamped one",
                  first_frequency_with(beam, 0.0), first_frequency_with(beam, kInfinity)),
      "No torsional spring gives another: check the beam and its masses.");
}

}  // namespace microslip
