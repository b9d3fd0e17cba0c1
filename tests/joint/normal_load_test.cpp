// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"
#include "support/figures.hpp"
#include "support/random_path.hpp"
#include "support/reference_csv.hpp"

namespace microslip::normal_load_test {
namespace {

// The case of [AR14 App. B]: φ = 0.2 on [0, 5] N, k = 1 N/m, as 200 elements of κ = 1/200 that slip
// at 5i/200²; x = 10 sin 2πt, p = 1 + 0.9 sin² 2πt, t in s.
constexpr int kElements = 200;

std::vector<JenkinsElement> elements() {
  std::vector<JenkinsElement> all;
  for (int i = 1; i <= kElements; ++i) {
    all.push_back({1.0 / kElements, 5.0 * i / (kElements * kElements)});
  }
  return all;
}

double sine(double t) { return std::sin(2.0 * std::numbers::pi * t); }
double displacement(double t) { return 10.0 * sine(t); }
double load(double t) { return 1.0 + 0.9 * sine(t) * sine(t); }

/// Forces of the second cycle, `steps` + 1 of them.
std::vector<double> second_cycle(NormalLoadLaw law, int steps) {
  std::vector<double> x;
  std::vector<double> p;
  for (int i = 0; i <= 2 * steps; ++i) {
    x.push_back(displacement(static_cast<double>(i) / steps));
    p.push_back(load(static_cast<double>(i) / steps));
  }
  std::vector<double> force(x.size());
  const JenkinsNetwork network(elements());
  NetworkMemory(network, law).march(x, p, force);
  return {force.begin() + steps, force.end()};
}

/// Largest difference at the 128 equal intervals of a cycle that all resolutions share.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i <= 128; ++i) {
    const double one = a[i * ((a.size() - 1) / 128)];
    const double other = b[i * ((b.size() - 1) / 128)];
    largest = std::max(largest, std::abs(one - other));
  }
  return largest;
}

// Values by an independent program, good to 1e-4 N; 4096 steps per cycle of a first-order law must
// be within 2e-3 N. The total law is exact at any step; its column is exact as far as the
// displacement of the second cycle is (1e-14 m) and so is the one at constant load.
TEST(NormalLoad, AgreesWithIndependentValues) {
  const testing::ReferenceTable table = testing::reference_table("variable_normal_load.csv");
  ASSERT_EQ(table.rows(), 129U);
  constexpr int kSteps = 4096;
  const std::vector<double> incremental = second_cycle(NormalLoadLaw::kIncremental, kSteps);
  const std::vector<double> total = second_cycle(NormalLoadLaw::kTotal, kSteps);
  double incremental_error = 0.0;
  double total_error = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t i = row * kSteps / 128;
    ASSERT_NEAR(table["displacement [m]"][row], displacement(table["time [s]"][row]), 1e-12);
    ASSERT_NEAR(table["normal_load [1]"][row], load(table["time [s]"][row]), 1e-12);
    const double from_incremental = std::abs(incremental[i] - table["force_incremental [N]"][row]);
    incremental_error = std::max(incremental_error, from_incremental);
    total_error = std::max(total_error, std::abs(total[i] - table["force_total [N]"][row]));
  }
  EXPECT_LT(incremental_error, 2e-3);
  EXPECT_LT(total_error, 1e-12);
  test::record_largest("incremental law [N]", incremental_error);
  test::record_largest("total law [N]", total_error);
}

// The total law needs no step at all: it only sees where the path turns.
TEST(NormalLoad, TotalLawIsExactAtAnyStep) {
  const std::vector<double> fine = second_cycle(NormalLoadLaw::kTotal, 8192);
  EXPECT_LT(difference(second_cycle(NormalLoadLaw::kTotal, 128), fine), 1e-12);
}

// And its force is p times that under constant load.
TEST(NormalLoad, TotalLawScalesTheForceUnderConstantLoad) {
  const JenkinsNetwork network(elements());
  const std::vector<double> x = testing::random_path(1, 500, 10.0, 3);
  NetworkMemory varying(network, NormalLoadLaw::kTotal);
  NetworkMemory constant(network, NormalLoadLaw::kTotal);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double p = 1.0 + 0.9 * std::sin(0.37 * static_cast<double>(i));
    EXPECT_NEAR(varying.advance(x[i], p), p * constant.advance(x[i]), 1e-14);
  }
}

// Errors between 512 and 8192 steps per cycle against 2^18, halving the step each time: the mean
// load of a step makes the law of second order, in the case of [AR14 App. B] and, within the
// scatter of where in a step the elements slip and stick, where neither the turns of x nor those of
// p fall on a sample.
TEST(NormalLoad, IncrementalLawConvergesWithSecondOrder) {
  const JenkinsNetwork network(elements());
  const auto other_cycle = [&](int steps) {
    std::vector<double> force;
    NetworkMemory memory(network);
    for (int i = 0; i <= 2 * steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double f = memory.advance(10.0 * sine(t + 0.0471), 1.0 + 0.6 * sine(3.0 * t + 0.1593));
      if (i >= steps) force.push_back(f);
    }
    return force;
  };
  const auto published_cycle = [](int steps) {
    return second_cycle(NormalLoadLaw::kIncremental, steps);
  };
  const auto check = [](const char* name, double scatter, const auto& cycle) {
    const std::vector<double> reference = cycle(1 << 18);
    std::vector<double> errors;
    for (const int steps : {512, 1024, 2048, 4096, 8192}) {
      errors.push_back(difference(cycle(steps), reference));
    }
    const double order = std::log2(errors.front() / errors.back()) / 4.0;
    EXPECT_NEAR(order, 2.0, scatter) << name;
    EXPECT_LT(errors.front(), 1e-3) << name;
    RecordProperty(std::string(name) + "_errors_N", ::testing::PrintToString(errors));
    test::record_smallest("order [1]", order);
  };
  check("published", 0.02, published_cycle);
  check("other", 0.2, other_cycle);
}

// p = 1: both laws are the Iwan model of the same sliders. Σκ = 1 N/m, so that slip force and slip
// displacement are one number. Incremental stretches sum the moves: 1500 roundings of 10 N at most.
TEST(NormalLoad, ConstantLoadIsTheExactMemory) {
  AtomsPart atoms;
  for (int i = 1; i <= kElements; ++i) {
    atoms.slip_force.push_back(5.0 * i / kElements);
    atoms.weight.push_back(1.0 / kElements);
  }
  const Joint joint(1.0, SlipDensity({atoms}));
  const JenkinsNetwork network(elements());
  const std::vector<double> x = testing::random_path(2, 500, 10.0, 3);
  const std::vector<double> ones(x.size(), 1.0);
  std::vector<double> exact(x.size());
  Memory(joint).march(x, exact);
  for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
    std::vector<double> force(x.size());
    NetworkMemory(network, law).march(x, ones, force);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(force[i], exact[i], 1e-12);
  }
}

// The difference between the laws [AR14 App. B: "some saturated elements return to elastic
// deformation"].
TEST(NormalLoad, ChangingLoadAtRestTellsTheLawsApart) {
  const std::vector<JenkinsElement> one = {{2.0, 1.0}};
  const JenkinsNetwork network(one);
  NetworkMemory incremental(network, NormalLoadLaw::kIncremental);
  NetworkMemory total(network, NormalLoadLaw::kTotal);
  // Stuck at half its slip force.
  EXPECT_DOUBLE_EQ(incremental.advance(0.25, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(total.advance(0.25, 1.0), 0.5);
  // More load: nothing moves, so ḟ = κpẋ gives nothing; the total law scales the stretch.
  EXPECT_DOUBLE_EQ(incremental.advance(0.25, 2.0), 0.5);
  EXPECT_DOUBLE_EQ(total.advance(0.25, 2.0), 1.0);
  // Less load than the force needs: it slips at rest.
  EXPECT_DOUBLE_EQ(incremental.advance(0.25, 0.25), 0.25);
  EXPECT_DOUBLE_EQ(total.advance(0.25, 0.25), 0.125);
  // The limit grows again: the element sticks, with the force it has left.
  EXPECT_DOUBLE_EQ(incremental.advance(0.25, 1.0), 0.25);
  // Separation and renewed contact.
  EXPECT_EQ(incremental.advance(0.5, 0.0), 0.0);
  EXPECT_EQ(total.advance(0.5, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(incremental.advance(0.5, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(total.advance(0.5, 1.0), 1.0);
}

// The spring beside the sliders carries k_e p ẋ or k_e p x.
TEST(NormalLoad, ScalesTheElasticRemainderToo) {
  const JenkinsNetwork spring({}, 3.0);
  NetworkMemory incremental(spring, NormalLoadLaw::kIncremental);
  NetworkMemory total(spring, NormalLoadLaw::kTotal);
  EXPECT_DOUBLE_EQ(incremental.advance(1.0, 2.0), 6.0);
  EXPECT_DOUBLE_EQ(incremental.advance(1.0, 1.0), 6.0);
  EXPECT_DOUBLE_EQ(incremental.advance(2.0, 3.0), 6.0 + 3.0 * 2.0);  // mean load 2
  EXPECT_DOUBLE_EQ(total.advance(1.0, 2.0), 6.0);
  EXPECT_DOUBLE_EQ(total.advance(1.0, 1.0), 3.0);
}

/// φ from [AR14 (4)] on the return branch from x = 10 m, p neglected: by (3) the branch is F(y) =
/// (f(10) - f(10 - 2y))/2, and φ = -F″/k², k = 1 N/m, by second differences over h = 0.25 m, ten of
/// the 200 slip displacements: at constant load they give 0.2 exactly. @return at y = h, 2h, … 9.5
/// m.
std::vector<double> density_of_return_branch(NormalLoadLaw law, bool varying) {
  const JenkinsNetwork network(elements());
  NetworkMemory memory(network, law);
  constexpr int kSteps = 4000;  // per branch; of equal length in x
  const auto advance = [&](double x) {
    return varying ? memory.advance(x, 1.0 + 0.009 * x * x) : memory.advance(x);
  };
  const auto branch = [&](double from, double to) {
    std::vector<double> force;
    for (int i = 0; i <= kSteps; ++i) force.push_back(advance(from + (to - from) * i / kSteps));
    return force;
  };
  branch(0.0, 10.0);
  branch(10.0, -10.0);
  branch(-10.0, 10.0);
  const std::vector<double> force = branch(10.0, -10.0);
  constexpr int kStride = kSteps / 40;  // h of y is 2h of x
  constexpr double kH = 0.25;
  std::vector<double> density;
  for (int j = 1; j < 39; ++j) {
    const auto f = [&](int i) {
      return 0.5 * (force.front() - force[static_cast<std::size_t>(i * kStride)]);
    };
    density.push_back(-(f(j + 1) - 2.0 * f(j) + f(j - 1)) / (kH * kH));
  }
  return density;
}

// [AR14 Fig. B1]: a density that comes out negative is the sign that the normal load varied.
TEST(NormalLoad, NeglectingItGivesANegativeDensity) {
  // Constant load: 0.2/N up to 5 N and nothing above, to the rounding 1e-14/h².
  const std::vector<double> constant = density_of_return_branch(NormalLoadLaw::kIncremental, false);
  for (std::size_t j = 0; j < constant.size(); ++j) {
    const double slip_force = 0.25 * static_cast<double>(j + 1);
    if (std::abs(slip_force - 5.0) < 0.1) continue;  // half of the step
    EXPECT_NEAR(constant[j], slip_force < 5.0 ? 0.2 : 0.0, 1e-11) << slip_force;
  }
  // Varying load: clearly below zero in both laws. Once all has slipped f = -2.5125 p(x), whose
  // second derivative gives φ = -2·2.5125·0.018, nearly half of the true density with the wrong
  // sign.
  for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
    const std::vector<double> varying = density_of_return_branch(law, true);
    EXPECT_LT(*std::ranges::min_element(varying), -0.09);
    EXPECT_NEAR(varying.back(), -0.09045, 1e-11);
    RecordProperty(law == NormalLoadLaw::kTotal ? "total" : "incremental",
                   ::testing::PrintToString(varying));
  }
}

}  // namespace
}  // namespace microslip::normal_load_test
