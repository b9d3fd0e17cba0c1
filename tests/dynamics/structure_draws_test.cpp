// SPDX-License-Identifier: MIT
#include "microslip/dynamics/draws/structure_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/structures.hpp"

namespace microslip::structure_draws_test {
namespace {

/// Two modes and two joints, of 1 and 2 N/m.
JointedStructure nominal() {
  ModalModel linear({{1.0, 0.01}, {3.0, 0.02}}, {{"a", {1.0, 0.5}}, {"b", {0.2, -1.0}}});
  const Joint soft(1.0, SlipDensity({UniformPart{0.0, 0.5, 0.9}}));
  const Joint hard(2.0, SlipDensity({UniformPart{0.0, 0.5, 0.9}}));
  return {std::move(linear),
          {{"soft", soft, {1.0, 0.0}}, {"hard", hard, {0.3, 0.4}}},
          {{"a"}, {"b", {0.5, {0.0, 1.0}}}}};
}

/// Draw i has a stiffness of 1 + i/1000 times that of the joint: it identifies the draw.
JointDraws numbered(double stiffness, std::size_t count) {
  return {count, [stiffness](std::size_t i) {
            const double k = stiffness * (1.0 + 1e-3 * static_cast<double>(i));
            return DrawnJoint{Joint(k, SlipDensity({UniformPart{0.0, 0.5, 0.9}}))};
          }};
}

std::size_t number_of(const StructureDraw& draw, std::size_t joint) {
  const double nominal = joint == 0 ? 1.0 : 2.0;
  const double k = draw.structure.joints()[joint].joint.stiffness();
  return static_cast<std::size_t>(std::lround(1e3 * (k / nominal - 1.0)));
}

StructureDraws draws_of(StructureSpread spread, std::vector<JointDraws> joints = {},
                        JointPairing pairing = JointPairing::kIndependent, std::uint64_t seed = 1) {
  return {nominal(), std::move(spread), std::move(joints), pairing, seed};
}

const StructureSpread kAll{.frequency = {0.1, 0.2},
                           .loss_factor = {0.3, 0.4},
                           .normal_load = {0.1, 0.2},
                           .force_gain = {0.05, 0.0},
                           .response_gain = 0.02};

TEST(StructureDraws, AreTheSameInAnyOrderAndOthersOfAnotherSeed) {
  const StructureDraws draws = draws_of(kAll);
  const double first = draws.draw(5).structure.linear().modes()[1].angular_frequency;
  static_cast<void>(draws.draw(0));
  EXPECT_EQ(draws.draw(5).structure.linear().modes()[1].angular_frequency, first);
  const StructureDraws again = draws_of(kAll);
  EXPECT_EQ(again.draw(5).structure.linear().modes()[1].angular_frequency, first);
  const StructureDraws others = draws_of(kAll, {}, JointPairing::kIndependent, 2);
  EXPECT_NE(others.draw(5).structure.linear().modes()[1].angular_frequency, first);
}

// Certain numbers are unchanged, and other uncertain ones do not change the draws of a number.
TEST(StructureDraws, OfANumberDoNotDependOnTheOthers) {
  const StructureDraws all = draws_of(kAll);
  const StructureDraws one = draws_of({.frequency = {0.0, 0.2}});
  for (const std::uint64_t i : {0U, 7U}) {
    const StructureDraw a = all.draw(i);
    const StructureDraw b = one.draw(i);
    EXPECT_EQ(b.structure.linear().modes()[0].angular_frequency, 1.0);
    EXPECT_EQ(b.structure.linear().modes()[1].angular_frequency,
              a.structure.linear().modes()[1].angular_frequency);
    EXPECT_EQ(b.structure.linear().modes()[1].loss_factor, 0.02);
    EXPECT_EQ(b.response_gain, 1.0);
    EXPECT_EQ(a.structure.excitations()[1].harmonics, nominal().excitations()[1].harmonics);
  }
}

/// Mean and standard deviation of ln v over 2000 draws: 0 and σ but for 4 of their own standard
/// deviations, σ/√2000 and σ/√4000.
template <typename Value>
void expect_log_normal(const StructureDraws& draws, double sigma, const Value& value) {
  constexpr int kDraws = 2000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = std::log(value(draws.draw(static_cast<std::uint64_t>(i))));
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 4.0 * sigma / std::sqrt(kDraws));
  EXPECT_NEAR(std::sqrt(squares / kDraws), sigma, 4.0 * sigma / std::sqrt(2.0 * kDraws));
}

TEST(StructureDraws, AreLogNormal) {
  const StructureDraws draws = draws_of(kAll);
  expect_log_normal(draws, 0.2, [](const StructureDraw& d) {
    return d.structure.linear().modes()[1].angular_frequency / 3.0;
  });
  expect_log_normal(draws, 0.3, [](const StructureDraw& d) {
    return d.structure.linear().modes()[0].loss_factor / 0.01;
  });
  expect_log_normal(draws, 0.2, [](const StructureDraw& d) {
    return d.structure.joints()[1].joint.density().largest_slip_force() / 0.5;
  });
  expect_log_normal(draws, 0.05, [](const StructureDraw& d) {
    return d.structure.excitations()[0].harmonics[0].real();
  });
  expect_log_normal(draws, 0.02, [](const StructureDraw& d) { return d.response_gain; });
}

TEST(StructureDraws, TakeEachDrawOfAJointOnceAPass) {
  constexpr std::size_t kCount = 50;
  const StructureDraws draws = draws_of({}, {numbered(1.0, kCount), {}});
  EXPECT_TRUE(draws.any());
  std::vector<std::size_t> passes[2];
  for (std::uint64_t i = 0; i < 2 * kCount; ++i) {
    passes[i / kCount].push_back(number_of(draws.draw(i), 0));
  }
  for (const auto& pass : passes) {
    EXPECT_EQ(std::set<std::size_t>(pass.begin(), pass.end()).size(), kCount);
  }
  EXPECT_NE(passes[0], passes[1]);
}

TEST(StructureDraws, GoTogetherOrApart) {
  constexpr std::size_t kCount = 50;
  const std::vector<JointDraws> joints{numbered(1.0, kCount), numbered(2.0, kCount)};
  const StructureDraws together = draws_of({}, joints, JointPairing::kTogether);
  const StructureDraws apart = draws_of({}, joints, JointPairing::kIndependent);
  std::size_t same = 0;
  for (std::uint64_t i = 0; i < 2 * kCount; ++i) {
    const StructureDraw pair = together.draw(i);
    EXPECT_EQ(number_of(pair, 0), number_of(pair, 1));
    const StructureDraw other = apart.draw(i);
    same += number_of(other, 0) == number_of(other, 1) ? 1 : 0;
  }
  EXPECT_LT(same, 10U);  // two of a hundred on average
}

TEST(StructureDraws, TakeTheDampingOfADraw) {
  const JointDraws damped{3, [](std::size_t i) {
                            DrawnJoint drawn = numbered(1.0, 3).at(i);
                            drawn.linear_damping = 0.25;
                            return drawn;
                          }};
  const StructureDraws draws = draws_of({}, {damped, {}});
  EXPECT_EQ(draws.draw(0).structure.joints()[0].linear_damping, 0.25);
  EXPECT_EQ(draws.draw(0).structure.joints()[1].linear_damping, 0.0);
}

TEST(StructureDraws, RefuseWhatDoesNotFit) {
  EXPECT_FALSE(draws_of({}).any());
  EXPECT_THROW(draws_of({.frequency = {0.1}}), InputError);
  EXPECT_THROW(draws_of({.loss_factor = {0.1, -0.1}}), InputError);
  EXPECT_THROW(draws_of({.normal_load = {0.1, 1.5}}), InputError);
  EXPECT_THROW(draws_of({.force_gain = {0.1, std::nan("")}}), InputError);
  EXPECT_THROW(draws_of({.response_gain = -1.0}), InputError);
  EXPECT_THROW(draws_of({}, {numbered(1.0, 5)}), InputError);
  EXPECT_THROW(draws_of({}, {numbered(1.0, 5), numbered(2.0, 6)}, JointPairing::kTogether),
               InputError);
}

}  // namespace
}  // namespace microslip::structure_draws_test
