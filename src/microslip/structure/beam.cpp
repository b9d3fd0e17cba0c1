// SPDX-License-Identifier: MIT
#include "microslip/structure/beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "microslip/base/error.hpp"
#include "microslip/base/requirement.hpp"
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

double first_frequency_with(Beam beam, double tip_stiffness) {
  beam.tip_stiffness = tip_stiffness;
  return BeamModes(beam, 1).frequency(0);
}

}  // namespace

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
  require(std::isfinite(first_frequency) && first_frequency > 0.0, "first_frequency",
          first_frequency, "must be positive and finite");
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
