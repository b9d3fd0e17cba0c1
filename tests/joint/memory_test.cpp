// SPDX-License-Identifier: MIT
#include "microslip/joint/memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/path.hpp"
#include "support/figures.hpp"
#include "support/random_path.hpp"
#include "support/reference_csv.hpp"

namespace microslip::memory_test {
namespace {

using testing::random_path;

Joint atoms_joint() {
  return Joint(1e5, SlipDensity({AtomsPart{{8.0, 15.0, 30.0}, {0.25, 0.35, 0.3}}}));
}

/// One joint per kind of virgin curve: cubics, cubics with an elastic remainder, power laws,
/// chords, a sum.
std::vector<Joint> all_kinds() {
  std::vector<Joint> joints;
  joints.emplace_back(1e5, SlipDensity({UniformPart{0.0, 30.0, 1.0}}));
  joints.emplace_back(
      1e5, SlipDensity({PiecewiseLinearPart{{0.0, 4.0, 9.0, 40.0}, {0.05, 0.03, 0.02, 0.0}}}));
  joints.emplace_back(1e5, SlipDensity({PowerLawPart{0.05, -1.0, 1.0, 40.0}}));
  joints.push_back(atoms_joint());
  joints.push_back(Joint::four_parameter(30.0, 1.5e5, -0.3, 0.2));
  joints.emplace_back(1e5, SlipDensity({UniformPart{0.0, 30.0, 0.4}, AtomsPart{{8.0}, {0.2}},
                                        PowerLawPart{0.02, -0.5, 0.0, 25.0}}));
  return joints;
}

constexpr double kAmplitude = 4e-4;  // m; kA = 40 N

std::vector<double> march(const Joint& joint, const std::vector<double>& x) {
  Memory memory(joint);
  std::vector<double> force(x.size());
  memory.march(x, force);
  return force;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void expect_same_state(const Memory& a, const Memory& b) {
  EXPECT_TRUE(same_bits(a.displacement(), b.displacement()));
  EXPECT_TRUE(same_bits(a.force(), b.force()));
  ASSERT_EQ(a.reversals().size(), b.reversals().size());
  for (std::size_t i = 0; i < a.reversals().size(); ++i) {
    EXPECT_TRUE(same_bits(a.reversals()[i].displacement, b.reversals()[i].displacement));
    EXPECT_TRUE(same_bits(a.reversals()[i].force, b.reversals()[i].force));
  }
  // The next step depends on the direction too, which has no accessor.
  for (const double x : {-2.0 * kAmplitude, 0.0, a.displacement(), 2.0 * kAmplitude}) {
    EXPECT_TRUE(same_bits(a.trial(x).force, b.trial(x).force));
    EXPECT_TRUE(same_bits(a.trial(x).tangent, b.trial(x).tangent));
  }
}

// ---- Against independent values. ----

// Atoms: exact values, printed with all digits; a stack of reversals adds a few roundings of 30 N.
// The four-parameter values are good to 1e-6 N.
TEST(Memory, FollowsAnIndependentlyComputedNestedPath) {
  const testing::ReferenceTable table = testing::reference_table("nested_path.csv");
  const std::vector<double>& x = table["displacement [m]"];
  ASSERT_GT(x.size(), 90U);
  const std::vector<double> atoms = march(atoms_joint(), x);
  const std::vector<double> four = march(Joint::four_parameter(30.0, 1.5e5, -0.3, 0.2), x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(atoms[i], table["force_atoms [N]"][i], 1e-12) << "row " << i;
    EXPECT_NEAR(four[i], table["force_four_parameter [N]"][i], 2e-6) << "row " << i;
    test::record_largest("atoms [N]", std::abs(atoms[i] - table["force_atoms [N]"][i]));
    test::record_largest("four-parameter [N]",
                         std::abs(four[i] - table["force_four_parameter [N]"][i]));
  }
}

// A network of play operators needs no memory rule: the same sliders, one by one, on 1e5 random
// turns. Forces are of order 10 N, of which 1e-12 N is 600 roundings: the depth of the stack times
// a few.
TEST(Memory, AgreesWithTheSameSlidersOneByOne) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    RandomStream random(seed, 1);
    AtomsPart atoms;
    std::vector<JenkinsElement> elements;
    const double k = 1e5;
    for (int i = 0; i < 12; ++i) {
      const double f = 30.0 * random.uniform();
      const double weight = 0.07 * random.uniform();
      atoms.slip_force.push_back(f);
      atoms.weight.push_back(weight);
      elements.push_back({k * weight, weight * f});
    }
    const Joint joint(k, SlipDensity({atoms}));
    const JenkinsNetwork network(elements, k * joint.density().elastic_remainder());
    const std::vector<double> x = random_path(seed, 100000, kAmplitude, seed < 4 ? 1 : 5);
    const std::vector<double> force = march(joint, x);
    std::vector<double> expected(x.size());
    NetworkMemory(network).march(x, expected);
    double error = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      error = std::max(error, std::abs(force[i] - expected[i]));
      largest = std::max(largest, std::abs(force[i]));
    }
    EXPECT_GT(largest, 5.0);
    EXPECT_LE(error, 1e-12) << "seed " << seed;
    test::record_largest("error [N]", error);
  }
}

// ---- The rules. ----

TEST(Memory, StartsOnTheVirginCurve) {
  for (const Joint& joint : all_kinds()) {
    for (const double sign : {1.0, -1.0}) {
      Memory memory(joint);
      EXPECT_EQ(memory.displacement(), 0.0);
      EXPECT_EQ(memory.force(), 0.0);
      EXPECT_EQ(memory.trial(0.0).force, 0.0);
      EXPECT_EQ(memory.trial(0.0).tangent, joint.tangent_stiffness(0.0));
      for (const double x : {1e-6, 1e-5, 1e-5, 2e-4, 9e-4}) {
        EXPECT_EQ(memory.advance(sign * x), joint.virgin_force(sign * x));
        EXPECT_EQ(memory.trial(sign * x).tangent, joint.tangent_stiffness(x));
        EXPECT_TRUE(memory.reversals().empty());
      }
    }
  }
}

// [AR14 (3)] about a reversal: f = f_r ± 2F(|x - x_r|/2), tangent F′(|x - x_r|/2); to a rounding.
TEST(Memory, FollowsMasingsRuleAfterAReversal) {
  for (const Joint& joint : all_kinds()) {
    const double top = joint.virgin_force(2e-4);
    Memory memory(joint);
    memory.advance(2e-4);
    for (const double x : {1.9e-4, 0.0, -1e-4}) {
      memory.advance(x);
      EXPECT_NEAR(memory.force(), top - 2.0 * joint.virgin_force((2e-4 - x) / 2.0), 1e-13);
      EXPECT_NEAR(memory.trial(x).tangent, joint.tangent_stiffness((2e-4 - x) / 2.0),
                  1e-12 * joint.stiffness());
      ASSERT_EQ(memory.reversals().size(), 1U);
      EXPECT_EQ(memory.reversals()[0].displacement, 2e-4);
      EXPECT_EQ(memory.reversals()[0].force, top);
    }
    const double bottom = memory.force();
    memory.advance(0.5e-4);
    EXPECT_NEAR(memory.force(), bottom + 2.0 * joint.virgin_force(1.5e-4 / 2.0), 1e-13);
    EXPECT_EQ(memory.reversals().size(), 2U);
  }
}

TEST(Memory, ForgetsClosedMinorLoops) {
  const Joint joint(1e5, SlipDensity({UniformPart{0.0, 30.0, 0.9}}));
  Memory memory(joint);
  const auto depth_after = [&](double x) {
    memory.advance(x);
    return memory.reversals().size();
  };
  EXPECT_EQ(depth_after(3e-4), 0U);
  EXPECT_EQ(depth_after(-2e-4), 1U);
  EXPECT_EQ(depth_after(1e-4), 2U);
  EXPECT_EQ(depth_after(-1e-4), 3U);
  EXPECT_EQ(depth_after(0.5e-4), 4U);
  EXPECT_EQ(depth_after(0.9e-4), 4U);
  EXPECT_EQ(depth_after(1e-4), 2U);     // closes [-1e-4, 1e-4] exactly at its end
  EXPECT_EQ(depth_after(-1.5e-4), 3U);  // a new one from there
  EXPECT_EQ(depth_after(-2.5e-4), 1U);  // passes both lower extremes at once
  EXPECT_EQ(depth_after(-2.6e-4), 1U);
  EXPECT_EQ(depth_after(0.0), 2U);
  EXPECT_EQ(depth_after(3.1e-4), 0U);  // all closed: virgin again
  EXPECT_EQ(memory.force(), joint.virgin_force(3.1e-4));
}

TEST(Memory, ContinuesTheVirginCurveBeyondTheLargestDisplacement) {
  for (const Joint& joint : all_kinds()) {
    for (const double sign : {1.0, -1.0}) {
      // Past the old extreme on the same side, and past its mirror image on the other.
      for (const double last : {3.1e-4, -3.1e-4}) {
        Memory memory(joint);
        for (const double x : {3e-4, -2e-4, 1e-4, -1e-4, last}) memory.advance(sign * x);
        EXPECT_EQ(memory.force(), joint.virgin_force(sign * last));
        EXPECT_TRUE(memory.reversals().empty());
        // And it remembers the new extreme: the branch back ends at its mirror image.
        memory.advance(-0.99 * sign * last);
        EXPECT_EQ(memory.reversals().size(), 1U);
        memory.advance(-sign * last);
        EXPECT_TRUE(memory.reversals().empty());
        EXPECT_EQ(memory.force(), joint.virgin_force(-sign * last));
      }
    }
  }
}

// The curves meet where they join: no jump of force when a loop closes or the virgin curve takes
// over. One ulp of x moves f by 1e-14 N; Masing's rule rounds at 30 N.
TEST(Memory, ForceIsContinuousWhereCurvesJoin) {
  for (const Joint& joint : all_kinds()) {
    Memory memory(joint);
    for (const double x : {3e-4, -2e-4, 1e-4, -1e-4}) memory.advance(x);
    for (const double joining : {1e-4, 3e-4}) {
      EXPECT_NEAR(memory.trial(std::nextafter(joining, 0.0)).force, memory.trial(joining).force,
                  1e-13);
    }
    EXPECT_NEAR(memory.trial(std::nextafter(-2e-4, 0.0)).force, memory.trial(-2e-4).force, 1e-13);
    EXPECT_NEAR(memory.trial(std::nextafter(-3e-4, 0.0)).force, memory.trial(-3e-4).force, 1e-13);
  }
}

// ---- Properties, on random paths. ----

// Return-point memory: whatever happens between, within the loop that is open, once the path is
// back at its start beyond which nothing has gone, it is as if nothing had happened. To 1e-12 N:
// the force there comes by another curve.
TEST(Memory, ReturnsToThePointWhereAnExcursionStarted) {
  for (const Joint& joint : all_kinds()) {
    RandomStream random(17, 0);
    for (int trial = 0; trial < 200; ++trial) {
      Memory memory(joint);
      memory.advance(kAmplitude);
      memory.advance(-kAmplitude * (0.8 + 0.19 * random.uniform()));
      const double x = kAmplitude * (0.6 * random.uniform() - 0.3);
      memory.advance(x);  // going up
      const Memory before = memory;
      const double low = x - 0.4 * kAmplitude * random.uniform();
      for (int i = 0; i < 30; ++i) memory.advance(low + (x - low) * random.uniform());
      memory.advance(x);
      EXPECT_NEAR(memory.force(), before.force(), 1e-12);
      EXPECT_EQ(memory.reversals().size(), before.reversals().size());
      for (const double next : {x - 1e-6, x + 1e-5, 0.9 * kAmplitude, 2.0 * kAmplitude}) {
        EXPECT_NEAR(memory.trial(next).force, before.trial(next).force, 1e-12);
      }
    }
  }
}

TEST(Memory, IsOdd) {
  for (const Joint& joint : all_kinds()) {
    const std::vector<double> x = random_path(5, 2000, kAmplitude, 4);
    std::vector<double> mirrored;
    for (const double value : x) mirrored.push_back(-value);
    const std::vector<double> force = march(joint, x);
    const std::vector<double> opposite = march(joint, mirrored);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_EQ(opposite[i], -force[i]);
  }
}

// Rate independence: samples between the turns change nothing. To 1e-12 N, since the forces at the
// turns are the same numbers and only equal positions could differ.
TEST(Memory, DoesNotDependOnHowAPathIsSampled) {
  for (const Joint& joint : all_kinds()) {
    const std::vector<double> turns = random_path(6, 500, kAmplitude);
    Memory coarse(joint);
    Memory fine(joint);
    double from = 0.0;
    for (const double to : turns) {
      for (int i = 1; i < 7; ++i) fine.advance(from + (to - from) * i / 7.0);
      EXPECT_EQ(coarse.advance(to), fine.advance(to));
      from = to;
    }
    expect_same_state(coarse, fine);
  }
}

// The slope never exceeds k, and a force moves with the displacement: |Δf| ≤ k|Δx|, ΔfΔx ≥ 0.
TEST(Memory, IsMonotoneAndNoStifferThanTheStuckJoint) {
  for (const Joint& joint : all_kinds()) {
    const std::vector<double> x = random_path(7, 5000, kAmplitude, 3);
    const std::vector<double> force = march(joint, x);
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double dx = x[i] - x[i - 1];
      const double df = force[i] - force[i - 1];
      EXPECT_LE(std::abs(df), joint.stiffness() * std::abs(dx) + 1e-12);
      EXPECT_GE(df * dx, -1e-12 * std::abs(dx));
    }
  }
}

// ∮ f dx over a steady cycle is D(A), about any mean. The trapezoidal rule over n steps per
// branch errs by at most h²/12·|Δf′| ≤ (2A/n)²/12·k on each of two branches, and by
// h²/8·k/2 at a corner of an atom: with n = 20 000 that is 1e-8·kA² at the very most.
TEST(Memory, SteadyCycleDissipatesWhatTheDensitySays) {
  for (const Joint& joint : all_kinds()) {
    for (const double a : {0.5e-4, 2e-4, 6e-4}) {
      for (const double mean : {0.0, 1e-4, -3e-4}) {
        Memory memory(joint);
        memory.advance(mean + a);
        memory.advance(mean - a);
        double energy = 0.0;
        constexpr int kSteps = 20000;
        for (int i = 1; i <= 2 * kSteps; ++i) {
          const double before_x = memory.displacement();
          const double before_force = memory.force();
          const double share = i <= kSteps ? i : 2 * kSteps - i;
          memory.advance(mean - a + 2.0 * a * share / kSteps);
          energy += 0.5 * (before_force + memory.force()) * (memory.displacement() - before_x);
        }
        EXPECT_NEAR(energy, dissipation(joint, a), 1e-8 * joint.stiffness() * a * a)
            << "A = " << a << ", mean " << mean;
      }
    }
  }
}

// ---- trial(), advance() and march() are one. ----

TEST(Memory, TrialPredictsAdvanceAndChangesNothing) {
  for (const Joint& joint : all_kinds()) {
    RandomStream random(8, 0);
    Memory memory(joint);
    for (const double x : random_path(8, 2000, kAmplitude, 3)) {
      const Memory before = memory;
      for (int i = 0; i < 3; ++i) (void)memory.trial(kAmplitude * (3.0 * random.uniform() - 1.5));
      expect_same_state(memory, before);
      const Memory::Response response = memory.trial(x);
      const double force = memory.advance(x);
      ASSERT_TRUE(same_bits(response.force, force));
      ASSERT_TRUE(same_bits(memory.force(), force));
      ASSERT_EQ(memory.displacement(), x);
      if (x != before.displacement()) {
        ASSERT_TRUE(same_bits(memory.trial(x).tangent, response.tangent));
      }
    }
  }
}

TEST(Memory, SettlesWhereAdvanceGoes) {
  for (const Joint& joint : all_kinds()) {
    Memory advanced(joint);
    Memory settled(joint);
    for (const double x : random_path(14, 2000, kAmplitude, 3)) {
      settled.settle(x, advanced.advance(x));
      expect_same_state(settled, advanced);
    }
  }
}

// The tangent of trial() is the derivative of its force in the direction of the move. A difference
// over h = 1e-9 m errs by h/2·f″ ≤ 0.5e-9·k²φ/2 = 1e-9·k·(1e5·0.05), and rounds at 1e-14 N/1e-9 m.
TEST(Memory, TangentIsTheSlopeOfTheStep) {
  const Joint joint(1e5, SlipDensity({PiecewiseLinearPart{{0.0, 9.0, 60.0}, {0.03, 0.02, 0.0}}}));
  Memory memory(joint);
  RandomStream random(9, 0);
  for (const double x : random_path(9, 500, kAmplitude)) {
    const double to = kAmplitude * (3.0 * random.uniform() - 1.5);
    const double h = to > memory.displacement() ? 1e-9 : -1e-9;
    const double slope = (memory.trial(to + h).force - memory.trial(to).force) / h;
    EXPECT_NEAR(memory.trial(to).tangent, slope, 1e-5 * joint.stiffness());
    memory.advance(x);
  }
}

void expect_march_equals_advance(const Joint& joint, const std::vector<double>& x,
                                 std::size_t piece) {
  Memory marched(joint);
  Memory advanced(joint);
  std::vector<double> force(x.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < x.size(); i += piece) {
    const std::size_t n = std::min(piece, x.size() - i);
    marched.march(std::span(x).subspan(i, n), std::span(force).subspan(i, n));
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_TRUE(same_bits(advanced.advance(x[i]), force[i])) << "sample " << i;
  }
  expect_same_state(marched, advanced);
}

// Pieces and lengths lie about the 256 samples that march() takes at a time.
TEST(Memory, MarchEqualsAdvanceBitForBit) {
  for (const Joint& joint : all_kinds()) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
      const std::vector<double> x = random_path(seed, 1500, kAmplitude, seed);
      for (const std::size_t piece : {1U, 7U, 255U, 256U, 257U, 512U, 100000U}) {
        expect_march_equals_advance(joint, x, piece);
      }
    }
  }
}

TEST(Memory, MarchEqualsAdvanceOnSpecialPaths) {
  std::vector<double> sine;
  for (int i = 0; i < 3000; ++i) {
    sine.push_back(kAmplitude * std::sin(2.0 * std::numbers::pi * i / 400.0));
  }
  std::vector<double> negative_sine;
  for (const double value : sine) negative_sine.push_back(-value);
  std::vector<double> rests(700, 0.0);  // at rest, then away, then at rest there
  rests.resize(1400, -1e-4);
  rests.resize(1410, 1e-4);
  std::vector<double> ramp;  // one branch over several blocks
  for (int i = 0; i < 1000; ++i) ramp.push_back(-1e-6 * i);
  std::vector<double> block_turns;  // turns and closings on the borders of blocks
  for (int i = 0; i < 6 * 256; ++i) {
    const int block = i / 256;
    const double progress = (i % 256) / 255.0;
    const double amplitude = kAmplitude * (block < 4 ? 1.0 - 0.2 * block : 1.0);
    block_turns.push_back((block % 2 == 0 ? 1.0 : -1.0) * amplitude * (2.0 * progress - 1.0));
  }
  std::vector<double> signed_zeros = {0.0, -0.0, 1e-5, 0.0, -0.0, -1e-5, -0.0, 0.0};
  for (const Joint& joint : all_kinds()) {
    for (const auto* x : {&sine, &negative_sine, &rests, &ramp, &block_turns, &signed_zeros}) {
      for (const std::size_t piece : {1U, 256U, 300U, 100000U}) {
        expect_march_equals_advance(joint, *x, piece);
      }
    }
  }
}

TEST(Memory, MarchOfNothingDoesNothing) {
  const Joint joint = atoms_joint();
  Memory memory(joint);
  memory.advance(1e-4);
  const Memory before = memory;
  memory.march({}, {});
  expect_same_state(memory, before);
}

// ---- State. ----

TEST(Memory, CopyIsASnapshot) {
  for (const Joint& joint : all_kinds()) {
    Memory memory(joint);
    for (const double x : random_path(10, 300, kAmplitude)) memory.advance(x);
    Memory snapshot = memory;
    const std::vector<double> onwards = random_path(11, 300, kAmplitude);
    std::vector<double> first;
    for (const double x : onwards) first.push_back(memory.advance(x));
    memory = snapshot;
    expect_same_state(memory, snapshot);
    for (std::size_t i = 0; i < onwards.size(); ++i) {
      ASSERT_TRUE(same_bits(memory.advance(onwards[i]), first[i]));
    }
  }
}

TEST(Memory, ResetIsVirgin) {
  const Joint joint = atoms_joint();
  Memory memory(joint);
  for (const double x : random_path(12, 50, kAmplitude)) memory.advance(x);
  memory.reset();
  expect_same_state(memory, Memory(joint));
  EXPECT_TRUE(memory.reversals().empty());
}

// ---- The rules on a path. ----

// Forces and energies beyond would be NaN: differences of displacements overflow, and their
// squares.
TEST(Memory, FollowsAJointAsFarAsItSays) {
  const Joint joint = atoms_joint();
  Memory memory(joint);
  EXPECT_TRUE(std::isfinite(memory.advance(kFarthestDisplacement)));
  EXPECT_TRUE(std::isfinite(memory.advance(-kFarthestDisplacement)));
  EXPECT_TRUE(std::isfinite(memory.dissipation(0.0)));
  EXPECT_TRUE(std::isfinite(memory.stored_energy()));
  const Memory before = memory;
  const std::string rule = "must be from -1e+100 to 1e+100 m";
  EXPECT_EQ(test::message_or("accepted", [&] { memory.advance(1e101); }),
            "displacement = 1e+101; " + rule);
  for (const double beyond : {-1e101, 1e101}) {  // on and back
    EXPECT_NE(test::message_or("accepted", [&] { memory.settle(beyond, 1.0); }), "accepted");
  }
  std::vector<double> force(2);
  EXPECT_EQ(test::message_or("accepted",
                             [&] {
                               memory.march(std::vector<double>{0.0, -1e308}, force);
                             }),
            "displacement[1] = -1e+308; " + rule);
  expect_same_state(memory, before);
}

TEST(Memory, RejectsAPathWithANonFiniteDisplacementBeforeAnyStep) {
  const Joint joint = atoms_joint();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    for (const std::size_t place : {std::size_t{0}, std::size_t{300}, std::size_t{599}}) {
      Memory memory(joint);
      for (const double x : {2e-4, -1e-4, 0.5e-4}) memory.advance(x);
      const Memory before = memory;
      std::vector<double> x = random_path(13, 600, kAmplitude);
      x.resize(600);
      x[place] = bad;
      if (place == 300) x[450] = bad;  // the first is named
      std::vector<double> force(x.size(), -7.0);
      try {
        memory.march(x, force);
        ADD_FAILURE() << "accepted " << bad;
      } catch (const InputError& error) {
        EXPECT_EQ(error.name(), "displacement[" + std::to_string(place) + "]");
        EXPECT_NE(std::string(error.what()).find("must be finite"), std::string::npos);
      }
      expect_same_state(memory, before);
      EXPECT_EQ(force, std::vector<double>(x.size(), -7.0));
    }
  }
}

TEST(Memory, RejectsForcesOfAnotherLength) {
  const Joint joint = atoms_joint();
  Memory memory(joint);
  const std::vector<double> x(3, 1e-4);
  std::vector<double> force(2);
  try {
    memory.march(x, force);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "length of force = 2; must be that of the displacements, 3");
  }
  EXPECT_EQ(memory.displacement(), 0.0);
}

// ---- Energies. ----

// Of the same sliders, one by one: each has a stretch e and loses f|dx| while it slips. Energies
// are of order 1e-3 J, the sum of 2e4 losses 1 J.
TEST(Memory, HasTheEnergiesOfTheSlidersOneByOne) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Joint joint = atoms_joint();
    const AtomsPart& atoms = joint.density().atoms();
    const double k = joint.stiffness();
    std::vector<double> stretch(atoms.weight.size());
    double lost = 0.0;
    double expected_loss = 0.0;
    Memory memory(joint);
    for (const double x : random_path(seed, 20000, kAmplitude, seed)) {
      double stored = 0.5 * k * joint.density().elastic_remainder() * x * x;
      for (std::size_t i = 0; i < stretch.size(); ++i) {
        const double limit = atoms.slip_force[i] / k;
        const double free = stretch[i] + x - memory.displacement();
        stretch[i] = std::clamp(free, -limit, limit);
        expected_loss += k * atoms.weight[i] * limit * std::abs(free - stretch[i]);
        stored += 0.5 * k * atoms.weight[i] * stretch[i] * stretch[i];
      }
      lost += memory.dissipation(x);
      memory.advance(x);
      ASSERT_NEAR(memory.stored_energy(), stored, 1e-15);
    }
    EXPECT_GT(expected_loss, 0.1);
    EXPECT_NEAR(lost, expected_loss, 1e-12 * expected_loss);
  }
}

// The work of the force, by Simpson's rule over 64 parts of a step, is what was lost and stored.
// Where an atom begins to slip inside of a part it errs by 64^−2 of a part of the work.
TEST(Memory, LosesAndStoresTheWorkOfItsForce) {
  for (const Joint& joint : all_kinds()) {
    Memory memory(joint);
    const double size = 0.5 * joint.stiffness() * kAmplitude * kAmplitude;
    for (const double to : random_path(5, 300, kAmplitude)) {
      const double before = memory.stored_energy();
      const double lost = memory.dissipation(to);
      const double from = memory.displacement();
      double work = memory.force() / 6.0;  // over the length of a part
      constexpr int kParts = 64;
      for (int i = 1; i <= 2 * kParts; ++i) {
        const double weight = i == 2 * kParts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        work += weight / 6.0 * memory.advance(from + (to - from) * i / (2.0 * kParts));
      }
      work *= (to - from) / kParts;
      ASSERT_NEAR(work, lost + memory.stored_energy() - before, 1e-4 * size);
      ASSERT_GE(lost, 0.0);
    }
  }
}

}  // namespace
}  // namespace microslip::memory_test
