// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/structure/beam.hpp"
#include "microslip/structure/beam_modes.hpp"
#include "structure/beams.hpp"

namespace microslip::beam_spring_test {
namespace {

using testing::kInfinity;
using testing::random_beam;
using testing::reference_beam;

double first_frequency(Beam beam, double spring) {
  beam.tip_stiffness = spring;
  return BeamModes(beam, 1).frequency(0);
}

// Over the whole of the attainable range, its ends nearly included.
TEST(SpringForFirstFrequency, ReturnsTheFrequency) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Beam beam = random_beam(seed);
    const double pinned = first_frequency(beam, 0.0);
    const double clamped = first_frequency(beam, kInfinity);
    for (const double share : {0.0, 1e-9, 1e-3, 0.1, 0.3, 0.5, 0.9, 0.999, 1.0 - 1e-6}) {
      const double wanted = pinned + share * (clamped - pinned);
      const double spring = spring_for_first_frequency(beam, wanted);
      EXPECT_NEAR(first_frequency(beam, spring), wanted, 1e-13 * wanted) << seed << ", " << share;
    }
  }
}

// The condition of the spring: δk = δ(ω²)/φ′(L)², with 1e-14 of ω².
TEST(SpringForFirstFrequency, ReturnsTheSpring) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Beam beam = random_beam(seed);
    if (std::isinf(beam.tip_stiffness)) beam.tip_stiffness = beam.bending_stiffness / beam.length;
    const BeamModes modes(beam, 1);
    const double omega = modes.angular_frequencies()[0];
    const double slope = modes.tip_slopes()[0];
    EXPECT_NEAR(spring_for_first_frequency(beam, modes.frequency(0)), beam.tip_stiffness,
                1e-14 * (omega * omega / (slope * slope) + beam.tip_stiffness))
        << seed;
  }
}

// 170 kN/m at 30 mm.
TEST(SpringForFirstFrequency, OfTheReferenceRig) {
  Beam beam = reference_beam(1.7e5 * 0.03 * 0.03, true);
  const double stuck = BeamModes(beam, 1).frequency(0);
  EXPECT_NEAR(stuck, 55.78, 0.005);
  EXPECT_NEAR(spring_for_first_frequency(beam, stuck), 153.0, 153.0 * 1e-12);
}

TEST(SpringForFirstFrequency, NamesTheRangeOfFrequencies) {
  const Beam beam = reference_beam(7.0, false);
  const auto message = [&](double frequency) {
    return test::message_of<InputError>(
        [&] { return spring_for_first_frequency(beam, frequency); });
  };
  const std::string range =
      "; must be at least 53.51143331 Hz, that of the pinned beam, and below 77.65018797 Hz, that "
      "of "
      "the clamped one. No torsional spring gives another: check the beam and its masses.";
  for (const std::string frequency : {"1", "53.5", "77.7", "200", "1e+300"}) {
    EXPECT_EQ(message(std::stod(frequency)), "first_frequency = " + frequency + range);
  }
  EXPECT_EQ(message(-1.0), "first_frequency = -1; must be positive and finite");
  EXPECT_EQ(message(std::nan("")), "first_frequency = nan; must be positive and finite");
}

TEST(SpringForFirstFrequency, ChecksTheBeam) {
  Beam beam = reference_beam(0.0, true);
  beam.masses[2].mass = -1.0;
  EXPECT_THROW((void)spring_for_first_frequency(beam, 55.0), InputError);
}

}  // namespace
}  // namespace microslip::beam_spring_test
