// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/structures.hpp"

namespace microslip::random_structures_test {
namespace {

/// Three damped modes, one to three joints of four kinds, and in every other structure a third
/// harmonic in the force, that makes sharp superharmonic resonances.
JointedStructure random_structure(std::uint64_t seed) {
  RandomStream random(seed, 1);
  const auto uniform = [&] { return 2.0 * random.uniform() - 1.0; };
  const std::vector<Mode> modes{{1.0, 0.02}, {2.0 + random.uniform(), 0.01}, {5.0, 0.01}};
  const std::vector<Joint> kinds = testing::joints_of_each_kind();
  std::vector<StructuralJoint> joints;
  for (std::size_t j = 0; j < 1 + seed % 3; ++j) {
    joints.push_back({.name = "joint " + std::to_string(j),
                      .joint = kinds[(seed + j) % 4],
                      .shape = {uniform(), uniform(), uniform()}});
  }
  std::vector<std::complex<double>> harmonics{1.0};
  if (seed % 2 == 1) harmonics = {1.0, 0.0, {0.3, 0.2}};
  return JointedStructure(ModalModel(modes, {{"a", {1.0, 0.6, 0.5}}, {"b", {0.4, -0.7, 0.3}}}),
                          std::move(joints), {{"a", harmonics}},
                          seed % 2 == 1 ? DampingLaw::kViscous : DampingLaw::kHysteretic);
}

// From stick far into macro-slip each curve gets to its end, with the balance that is promised, and
// without turning round: it ends where it should, and its points nowhere lie far apart.
TEST(FrequencyResponse, OfRandomStructuresReachesItsEnd) {
  for (std::uint64_t seed = 1; seed <= (test::kSanitized ? 4 : test::draws_of(16, 8)); ++seed) {
    const HarmonicBalance balance(random_structure(seed), {seed % 2 == 1 ? "a" : "b"},
                                  {.samples = 128});
    for (const double force : {1e-3, 0.05, 0.3, 2.0}) {
      const ResponseCurve curve = balance.frequency_response(force, 0.4, 3.5);
      EXPECT_TRUE(curve.summary.converged())
          << "seed " << seed << ", " << force << " N: " << curve.summary.full();
      EXPECT_NEAR(curve.points.back().angular_frequency, 3.5, 1e-10);
      EXPECT_GE(curve.peaks.size(), 1U);
      for (std::size_t i = 1; i < curve.points.size(); ++i) {
        EXPECT_LE(curve.points[i].energy_imbalance, 1e-8);
        test::record_largest("energy imbalance [1]", curve.points[i].energy_imbalance);
        const double step =
            curve.points[i].angular_frequency - curve.points[i - 1].angular_frequency;
        EXPECT_LE(step, 0.05 * 3.1 * 1.5);  // least_points, and what a bent step may add
      }
    }
  }
}

/// Hardly damped, all joints of atoms: their onset of slip makes corners in the curves.
JointedStructure structure_of_atoms(std::uint64_t seed) {
  RandomStream random(seed, 2);
  const auto uniform = [&] { return 2.0 * random.uniform() - 1.0; };
  const std::vector<Mode> modes{{1.0, 1e-3}, {1.4 + random.uniform(), 1e-3}, {3.3, 1e-3}};
  std::vector<StructuralJoint> joints;
  for (std::size_t j = 0; j < 2 + seed % 2; ++j) {
    const double slip = 0.02 + 0.2 * random.uniform();
    joints.push_back({.name = "joint " + std::to_string(j),
                      .joint = Joint(0.5 + random.uniform(),
                                     SlipDensity({AtomsPart{{slip, 2.0 * slip}, {0.6, 0.4}}})),
                      .shape = {uniform(), uniform(), uniform()}});
  }
  return JointedStructure(ModalModel(modes, {{"a", {1.0, 0.6, 0.5}}}), std::move(joints), {{"a"}});
}

TEST(FrequencyResponse, GoesRoundTheCornersOfAtoms) {
  for (std::uint64_t seed = 1; seed <= (test::kSanitized ? 8 : test::draws_of(24, 12)); ++seed) {
    const HarmonicBalance balance(structure_of_atoms(seed), {"a"},
                                  {.harmonics = 3, .samples = 128});
    const ResponseCurve curve = balance.frequency_response(0.05, 0.6, 3.0);
    EXPECT_TRUE(curve.summary.converged()) << "seed " << seed << ": " << curve.summary.full();
    for (const SteadyVibration& point : curve.points) EXPECT_LE(point.energy_imbalance, 1e-8);
  }
}

}  // namespace
}  // namespace microslip::random_structures_test
