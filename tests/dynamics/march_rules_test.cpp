// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "support/messages.hpp"
#include "support/structures.hpp"

namespace microslip::march_rules_test {
namespace {

using test::expect_message;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string message(const LoadHistory& loads, const MarchOptions& options = {}) {
  return test::message_or(
      "", [&] { return march(testing::one_mass(testing::iwan_joint()), loads, options); });
}

LoadHistory push() { return {{0.0, 1.0, 3.0}, {{"mass", {0.0, 0.1, 0.0}}}}; }

/// 40 periods or so of 0.05 N near resonance.
LoadHistory vibration(std::size_t count = 1000) {
  LoadHistory loads{{}, {{"mass", {}}}};
  for (std::size_t i = 0; i < count; ++i) {
    loads.time.push_back(0.25 * static_cast<double>(i));
    loads.forces[0].force.push_back(0.05 * std::sin(0.95 * loads.time.back()));
  }
  return loads;
}

TEST(MarchRules, NameTheTimeThatIsWrong) {
  EXPECT_EQ(message(push()), "");
  expect_message(message({{0.0}, {}}), "number of times = 1; must be at least 2");
  expect_message(message({{0.0, 1.0, 1.0}, {}}),
                 "time[2] = 1; must be later than the previous time");
  expect_message(message({{0.0, kNan}, {}}), "time[1] = nan; must be");
  expect_message(message({{0.0, HUGE_VAL}, {}}), "time[1] = inf; must be finite");
}

TEST(MarchRules, NameTheForceThatIsWrong) {
  LoadHistory loads = push();
  loads.forces[0].force[1] = kNan;
  expect_message(message(loads), "force at 'mass', value 1 = nan; must be finite");
  loads.forces[0].force[1] = 1e13;
  expect_message(message(loads), "value 1 = 10000000000000; must be finite, and");
  loads.forces[0].force.pop_back();
  expect_message(message(loads), "force at 'mass' = 2 values; must have 3");
  loads = push();
  loads.forces.push_back(loads.forces[0]);
  expect_message(message(loads), "force at 'mass' = twice; must be given once");
  loads.forces[1].point = "nose";
  expect_message(message(loads), "nose");
}

TEST(MarchRules, NameTheNormalLoadThatIsWrong) {
  LoadHistory loads = push();
  loads.normal_loads = {{"joint", {1.0, -0.1, 1.0}}};
  expect_message(message(loads), "normal load of joint 'joint', value 1 = -0.1; must be 0 or more");
  loads.normal_loads = {{"joint", {1.0, 1.0}}};
  expect_message(message(loads), "normal load of joint 'joint' = 2 values; must have 3");
  loads.normal_loads = {{"knee", {1.0, 1.0, 1.0}}};
  expect_message(message(loads), "knee; must be that of a joint of the structure");
}

TEST(MarchRules, NameTheOptionThatIsWrong) {
  expect_message(message(push(), {.step = -1.0}), "step = -1; must be positive");
  expect_message(message(push(), {.step = kNan}), "step = nan");
  expect_message(message(push(), {.every = 0}), "every = 0");
  expect_message(message(push(), {.tolerance = 0.0}), "tolerance = 0");
  expect_message(message(push(), {.max_iterations = 1}), "max_iterations = 1");
  expect_message(message(push(), {.largest_imbalance = 0.0}), "largest_imbalance = 0");
  expect_message(message(push(), {.largest_error = -1.0}), "largest_error = -1; must be positive");
  expect_message(message(push(), {.points = {"nose"}}), "nose");
  expect_message(message(push(), {.points = {"mass", "mass"}}), "mass; must be given once");
  expect_message(message(push(), {.start = {.displacement = {1.0, 2.0}}}),
                 "start displacement = 2 values; must have 1");
  expect_message(message(push(), {.start = {.velocity = {kNan}}}), "start velocity[0] = nan");
  LoadHistory loads = push();
  loads.normal_loads = {{"joint", {1.0, 1.0, 1.0}}};
  expect_message(message(loads, {.elements = 0}), "number of elements = 0");
}

// Steps without end, or more of them than a number can count. The chosen step is 0.31 s.
TEST(MarchRules, RefuseAStepThatWouldNeverEnd) {
  for (const double step : {1e-300, std::numeric_limits<double>::denorm_min(), 1e-18, 2.9e-10}) {
    expect_message(message(push(), {.step = step}), "; must be at least 3e-10 s");
  }
  expect_message(message(push(), {.step = 1e-300}), "step = 1e-300; must");
  EXPECT_EQ(message(push(), {.step = 1e-3}), "");
  expect_message(message({{0.0, 1e10}, {}}), "step = 0.314");
  expect_message(message({{-1e308, 1e308}, {}}, {.step = 1e300}), "step = 1e+300; must");
}

TEST(MarchRecords, AreEveryNthAndTheLast) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const LoadHistory loads = vibration(24);
  const MarchResult all = march(structure, loads, {.points = {"mass"}});
  const MarchResult some = march(structure, loads, {.every = 10, .points = {"mass"}});
  ASSERT_EQ(all.time.size(), 24U);
  EXPECT_EQ(some.time, (std::vector<double>{0.0, 2.5, 5.0, 5.75}));
  const std::vector<std::size_t> kept{0, 10, 20, 23};
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(some.points[0].displacement[i], all.points[0].displacement[kept[i]]);
    EXPECT_EQ(some.points[0].velocity[i], all.points[0].velocity[kept[i]]);
    EXPECT_EQ(some.points[0].acceleration[i], all.points[0].acceleration[kept[i]]);
    EXPECT_EQ(some.joints[0].force[i], all.joints[0].force[kept[i]]);
    EXPECT_EQ(some.joints[0].displacement[i], all.joints[0].displacement[kept[i]]);
  }
  // The joint sits on the mass, to the tolerance of the steps.
  EXPECT_NEAR(all.joints[0].displacement[23], all.points[0].displacement[23], 1e-9);
}

TEST(MarchProgress, IsReportedAndMayCancel) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  std::vector<std::size_t> reported;
  const auto listen = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 9999U);
    reported.push_back(done);
    return true;
  };
  (void)march(structure, vibration(10000), {}, listen);
  EXPECT_GE(reported.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(reported));
  EXPECT_EQ(reported.back(), 9999U);
  const auto stop = [](std::size_t, std::size_t) { return false; };
  EXPECT_THROW((void)march(structure, vibration(3000), {}, stop), Cancelled);
}

// So fast that shortening, which grows with the square of the distance, is infinite after a
// millionth of a step: no piece of it is short enough.
TEST(MarchFailure, SaysWhereAndKeepsWhatWasFound) {
  const JointedStructure rig = testing::friction_rig(3);
  const std::string point = rig.excitations()[0].point;
  const LoadHistory loads{{0.5, 0.501, 0.502}, {}};
  const MarchResult found = march(
      rig, loads, {.step = 1e-3, .points = {point}, .start = {.velocity = {1e170, 0.0, 0.0}}});
  EXPECT_FALSE(found.summary.converged());
  expect_message(found.summary.reason,
                 "step 1, from 0.5 s on, did not converge in 50 iterations, nor did pieces of it");
  ASSERT_EQ(found.time, std::vector<double>{0.5});
  EXPECT_EQ(found.points[0].displacement, std::vector<double>{0.0});
  EXPECT_EQ(found.joints[0].force, std::vector<double>{0.0});
  ASSERT_FALSE(found.error_estimate.has_value());
}

// Two rounds do not find the forces of a long step to 1e-14: pieces of it are taken.
TEST(MarchFailure, CutsStepsThatDoNotConverge) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const LoadHistory loads = vibration(100);
  const MarchResult whole =
      march(structure, loads, {.step = 0.25, .points = {"mass"}, .tolerance = 1e-14});
  const MarchResult cut =
      march(structure, loads,
            {.step = 0.25, .points = {"mass"}, .tolerance = 1e-14, .max_iterations = 2});
  ASSERT_TRUE(cut.summary.converged()) << cut.summary.full();
  EXPECT_GT(cut.steps, 2 * whole.steps);
  const auto& expected = whole.points[0].displacement;
  ASSERT_EQ(cut.points[0].displacement.size(), expected.size());
  // The whole steps of a twenty-fifth of a period err by some 1e-5.
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(cut.points[0].displacement[i], expected[i], 1e-4) << i;
  }
}

// Steps beyond the bound of stability, 0.25 N/m on 1e-4 kg of a body without a spring, 50 rad/s, do
// not converge, and are cut until they do.
TEST(MarchFailure, CutsUnstableSteps) {
  const JointedStructure structure(ModalModel({{0.0, 0.0}}, {{"body", {100.0}}}),
                                   {{"joint", testing::iwan_joint(), {100.0}}}, {{"body"}});
  LoadHistory loads{{}, {{"body", {}}}};
  for (int i = 0; i < 400; ++i) {
    loads.time.push_back(0.0645 * i);
    loads.forces[0].force.push_back(0.01 * std::sin(5.0 * loads.time.back()));
  }
  const MarchResult coarse =
      march(structure, loads, {.step = 0.0645, .points = {"body"}, .estimate_error = false});
  const MarchResult chosen = march(structure, loads, {.points = {"body"}});
  EXPECT_TRUE(chosen.summary.converged()) << chosen.summary.full();
  EXPECT_LT(chosen.energy.imbalance(), 1e-4);
  double difference = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < loads.time.size(); ++i) {
    const double expected = chosen.points[0].displacement[i];
    difference = std::max(difference, std::abs(coarse.points[0].displacement[i] - expected));
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_LT(difference, 0.05 * largest);  // a step is half a radian and more of the force
}

TEST(MarchFailure, ShowsInTheBalanceAndTheEstimate) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const MarchResult fine = march(structure, vibration());
  ASSERT_TRUE(fine.summary.converged()) << fine.summary.full();
  ASSERT_TRUE(fine.error_estimate.has_value());
  MarchResult found =
      march(structure, vibration(), {.largest_imbalance = 0.5 * fine.energy.imbalance()});
  EXPECT_FALSE(found.summary.converged());
  expect_message(found.summary.reason, "the energy balance is off by");
  found = march(structure, vibration(), {.largest_error = 0.5 * *fine.error_estimate});
  EXPECT_FALSE(found.summary.converged());
  expect_message(found.summary.reason, "the error of the displacements is estimated at");
  found = march(structure, vibration(), {.estimate_error = false});
  EXPECT_FALSE(found.error_estimate.has_value());
}

// The largest values are those at the ends of all steps, whichever times are recorded.
TEST(MarchRows, DoNotDecideOnTheLargest) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const LoadHistory loads = vibration(50);
  const MarchResult all = march(structure, loads, {.points = {"mass"}});
  const MarchResult few = march(structure, loads, {.every = 1000, .points = {"mass"}});
  ASSERT_EQ(few.time.size(), 2U);
  LargestMotion recorded;
  double reach = 0.0;
  for (std::size_t k = 0; k < all.time.size(); ++k) {
    const PointMotion& mass = all.points[0];
    recorded.displacement = std::max(recorded.displacement, std::abs(mass.displacement[k]));
    recorded.velocity = std::max(recorded.velocity, std::abs(mass.velocity[k]));
    recorded.acceleration = std::max(recorded.acceleration, std::abs(mass.acceleration[k]));
    reach = std::max(reach, std::abs(all.joints[0].displacement[k]));
  }
  constexpr double kBetween = 1.01;  // of steps that are a small part of a period
  const auto is_beyond = [&](double largest, double of_rows) {
    EXPECT_GE(largest, of_rows);
    EXPECT_LT(largest, kBetween * of_rows);
  };
  for (const MarchResult* result : {&all, &few}) {
    EXPECT_EQ(result->reached, loads.time.back());
    ASSERT_EQ(result->largest.size(), 1U);
    is_beyond(result->largest[0].displacement, recorded.displacement);
    is_beyond(result->largest[0].velocity, recorded.velocity);
    is_beyond(result->largest[0].acceleration, recorded.acceleration);
    ASSERT_EQ(result->reach.size(), 1U);
    is_beyond(result->reach[0], reach);
  }
  EXPECT_EQ(all.largest[0].displacement, few.largest[0].displacement);
  EXPECT_EQ(all.reach, few.reach);
}

// A push given by four times, and by four hundred: what happens between them counts for the largest
// motion and for the estimate of the error.
TEST(MarchRows, NeedNotBeManyForTheLargestAndTheError) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const LoadHistory few{{0.0, 1.0, 2.0, 80.0}, {{"mass", {0.0, 1.0, 0.0, 0.0}}}, {}};
  LoadHistory many{{}, {{"mass", {}}}, {}};
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.2 * i;
    many.time.push_back(t);
    many.forces[0].force.push_back(std::max(0.0, 1.0 - std::abs(t - 1.0)));
  }
  const MarchResult of_few = march(structure, few, {.step = 0.05, .points = {"mass"}});
  const MarchResult of_many = march(structure, many, {.step = 0.05, .points = {"mass"}});
  EXPECT_GT(of_few.largest[0].displacement, 2.0 * std::abs(of_few.points[0].displacement[3]));
  EXPECT_NEAR(of_few.largest[0].displacement, of_many.largest[0].displacement,
              1e-3 * of_many.largest[0].displacement);
  EXPECT_NEAR(of_few.reach[0], of_many.reach[0], 1e-3 * of_many.reach[0]);
  ASSERT_EQ(of_few.sizes.size(), 5U);  // w, ẇ, ẅ, u, F
  for (std::size_t s = 0; s < of_few.sizes.size(); ++s) {
    EXPECT_NEAR(of_few.sizes[s].peak, of_many.sizes[s].peak, 1e-3 * of_many.sizes[s].peak);
    EXPECT_NEAR(of_few.sizes[s].rms, of_many.sizes[s].rms, 1e-3 * of_many.sizes[s].rms);
  }
  EXPECT_EQ(of_few.sizes[1].peak, of_few.largest[0].velocity);
  EXPECT_EQ(of_few.sizes[3].peak, of_few.reach[0]);
  ASSERT_TRUE(of_few.error_estimate && of_many.error_estimate);
  EXPECT_NEAR(*of_few.error_estimate, *of_many.error_estimate, 0.5 * *of_many.error_estimate);
}

// The rows passed on one by one are those that march() keeps.
TEST(MarchRows, AreThoseOfTheResult) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const LoadHistory loads = vibration(50);
  const MarchOptions options{.every = 7, .points = {"mass"}};
  const MarchResult kept = march(structure, loads, options);
  std::size_t row = 0;
  const auto compare = [&](const MarchRow& given) {
    ASSERT_LT(row, kept.time.size());
    EXPECT_EQ(loads.time[given.index], given.time);
    EXPECT_EQ(given.time, kept.time[row]);
    EXPECT_EQ(given.displacement[0], kept.points[0].displacement[row]);
    EXPECT_EQ(given.velocity[0], kept.points[0].velocity[row]);
    EXPECT_EQ(given.acceleration[0], kept.points[0].acceleration[row]);
    EXPECT_EQ(given.joint_displacement[0], kept.joints[0].displacement[row]);
    EXPECT_EQ(given.joint_force[0], kept.joints[0].force[row]);
    ++row;
  };
  const MarchResult given = march_rows(structure, loads, options, compare);
  EXPECT_EQ(row, kept.time.size());
  EXPECT_TRUE(given.time.empty());
  EXPECT_EQ(given.energy.input, kept.energy.input);
  EXPECT_EQ(given.error_estimate, kept.error_estimate);
}

TEST(March, TakesHystereticDampingAsViscous) {
  const JointedStructure hysteretic = testing::friction_rig(3);
  const JointedStructure viscous(
      hysteretic.linear(), {hysteretic.joints().begin(), hysteretic.joints().end()},
      {hysteretic.excitations().begin(), hysteretic.excitations().end()});
  LoadHistory loads = vibration(50);
  const std::string point = hysteretic.excitations()[0].point;
  loads.forces[0].point = point;
  for (double& time : loads.time) time *= 1e-3;
  const MarchResult found = march(hysteretic, loads, {.points = {point}});
  EXPECT_EQ(found.points[0].displacement,
            march(viscous, loads, {.points = {point}}).points[0].displacement);
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_EQ(found.warnings[0].code, "hysteretic_as_viscous");
}

TEST(March, SaysNothingOfADampingThatIsNone) {
  const JointedStructure structure(ModalModel({{1.0, 0.0}}, {{"mass", {1.0}}}), {}, {{"mass"}},
                                   DampingLaw::kHysteretic);
  LoadHistory loads = vibration(50);
  EXPECT_TRUE(march(structure, loads, {.points = {"mass"}}).warnings.empty());
}

}  // namespace
}  // namespace microslip::march_rules_test
