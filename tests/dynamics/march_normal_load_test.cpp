// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/dynamics/march/march.hpp"
#include "support/largest_difference.hpp"
#include "support/structures.hpp"

namespace microslip::march_normal_load_test {
namespace {

constexpr double kStep = 0.05;  // s; 120 a period
constexpr std::size_t kCount = 2001;

Joint uniform_joint() { return Joint(0.25, SlipDensity({UniformPart{0.0, 0.2, 1.0}})); }

/// Near resonance for 16 periods; the load varies with twice the frequency [AR14 App. B].
LoadHistory vibration(double variation, NormalLoadLaw law) {
  LoadHistory loads{{}, {{"mass", {}}}, {{"joint", {}, law}}};
  for (std::size_t i = 0; i < kCount; ++i) {
    const double t = kStep * static_cast<double>(i);
    loads.time.push_back(t);
    loads.forces[0].force.push_back(0.05 * std::sin(0.95 * t));
    loads.normal_loads[0].load.push_back(1.0 + variation * std::pow(std::sin(0.95 * t), 2));
  }
  return loads;
}

// At p = 1 the elements are the joint: 1000 of them to 1e-6 of its force. The chosen step must keep
// the energy to 1e-4.
TEST(MarchNormalLoad, OfOneIsTheMemory) {
  const JointedStructure structure = testing::one_mass(uniform_joint());
  for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
    LoadHistory loads = vibration(0.0, law);
    const MarchResult elements = march(structure, loads, {.points = {"mass"}});
    loads.normal_loads.clear();
    const MarchResult exact = march(structure, loads, {.step = kStep, .points = {"mass"}});
    ASSERT_TRUE(elements.summary.converged()) << elements.summary.full();
    EXPECT_LT(
        testing::largest_difference(exact.points[0].displacement, elements.points[0].displacement),
        1e-4);
    EXPECT_LT(elements.energy.imbalance(), 1e-4);
    // The energy into the joint is that lost and that stored.
    const double work = exact.energy.joint_dissipation() + exact.energy.joint_stored();
    EXPECT_NEAR(elements.energy.joint_dissipation(), work, 1e-3 * work);
  }
}

// Between loads ≥ 0 there is none below, whatever the last digits of its steps.
TEST(MarchNormalLoad, MayFallToNothing) {
  const JointedStructure structure = testing::one_mass(uniform_joint());
  for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
    for (const double end : {0.1, 0.3, 0.7, 1.1}) {
      const LoadHistory loads{
          {0.0, end, 2.0 * end}, {{"mass", {0.1, 0.1, 0.1}}}, {{"joint", {1.0, 0.0, 1.0}, law}}};
      EXPECT_NO_THROW((void)march(structure, loads, {.points = {"mass"}})) << end;
    }
  }
}

// A displaced start under a load that is not 1, with a compliance in series: the first force and
// displacement of the joint are those of the elements themselves, F(u) = p F₁(u) and u + cF = q.
// 1e-4 of the force is what 1000 elements leave.
TEST(MarchNormalLoad, StartsOnTheVirginCurveOfItsLoad) {
  constexpr double kCompliance = 1.5;
  for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
    for (const double p : {0.0, 0.3, 1.0, 2.5}) {
      const JointedStructure structure(ModalModel({{0.9, 0.01}}, {{"mass", {1.0}}}),
                                       {{.name = "joint",
                                         .joint = uniform_joint(),
                                         .shape = {1.0},
                                         .series_compliance = kCompliance}},
                                       {{"mass"}});
      const LoadHistory loads{{0.0, 0.01}, {}, {{"joint", {p, p}, law}}};
      const MarchResult found = march(structure, loads, {.start = {.displacement = {0.7}}});
      const double u = found.joints[0].displacement[0];
      const double force = found.joints[0].force[0];
      EXPECT_NEAR(u + kCompliance * force, 0.7, 1e-4 * 0.7) << p;
      EXPECT_NEAR(force, p * uniform_joint().virgin_force(u),
                  1e-4 * uniform_joint().virgin_force(u))
          << p;
    }
  }
}

/// The motion by the leapfrog scheme with centred damping, of second order, from the same network.
std::vector<double> leapfrog(const LoadHistory& loads, int parts) {
  const JenkinsNetwork network = JenkinsNetwork::discretise(uniform_joint(), 1000);
  NetworkMemory memory(network, loads.normal_loads[0].law);
  const double h = kStep / parts;
  const auto between = [&](const std::vector<double>& values, std::size_t i, int part) {
    const double share = static_cast<double>(part) / parts;
    return share == 0.0 ? values[i] : values[i] + share * (values[i + 1] - values[i]);
  };
  std::vector<double> result;
  double q = 0.0;
  double v = 0.0;  // half a step behind
  double joint = memory.advance(0.0, loads.normal_loads[0].load[0]);
  for (std::size_t i = 0; i < kCount; ++i) {
    result.push_back(q);
    for (int part = 0; part < parts && i + 1 < kCount; ++part) {
      const double load = between(loads.forces[0].force, i, part) - 0.75 * q - joint;
      v = ((1.0 - 0.005 * h) * v + h * load) / (1.0 + 0.005 * h);
      q += h * v;
      const double p = part + 1 == parts ? loads.normal_loads[0].load[i + 1]
                                         : between(loads.normal_loads[0].load, i, part + 1);
      joint = memory.advance(q, p);
    }
  }
  return result;
}

// Against another scheme with steps of a twentieth, (0.0025 rad)²/12 = 5e-7 of a period's phase in
// 16 periods, on the same network. The march errs by some 1e-5; the laws differ by far more.
TEST(MarchNormalLoad, FollowsBothLaws) {
  const JointedStructure structure = testing::one_mass(uniform_joint());
  std::vector<std::vector<double>> of_law;
  for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
    const LoadHistory loads = vibration(0.9, law);
    const MarchResult found = march(structure, loads, {.points = {"mass"}});
    ASSERT_TRUE(found.summary.converged()) << found.summary.full();
    EXPECT_LT(testing::largest_difference(leapfrog(loads, 20), found.points[0].displacement), 5e-4);
    of_law.push_back(found.points[0].displacement);
  }
  EXPECT_GT(testing::largest_difference(of_law[0], of_law[1]), 0.02);
}

}  // namespace
}  // namespace microslip::march_normal_load_test
