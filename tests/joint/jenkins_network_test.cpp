// SPDX-License-Identifier: MIT
#include "microslip/joint/jenkins_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/memory.hpp"
#include "support/messages.hpp"
#include "support/random_path.hpp"

namespace microslip::jenkins_network_test {
namespace {

using testing::random_path;

constexpr double kStiffness = 1e5;  // N/m

/// F of a network, from its definition: Σ κ min(x, x_s) + κ_e x.
double virgin_force(const JenkinsNetwork& network, double x) {
  double sum = network.elastic_stiffness() * x;
  for (std::size_t i = 0; i < network.size(); ++i) {
    sum += network.stiffness()[i] * std::min(x, network.slip_displacement()[i]);
  }
  return sum;
}

/// D of a network: Σ 4κx_s(A - x_s) over the elements that slip.
double cycle_energy(const JenkinsNetwork& network, double amplitude) {
  double sum = 0.0;
  for (std::size_t i = 0; i < network.size(); ++i) {
    const double slip = network.slip_displacement()[i];
    if (slip < amplitude) sum += 4.0 * network.stiffness()[i] * slip * (amplitude - slip);
  }
  return sum;
}

/// Σ of weight·slip^n over the elements, in the units of the density.
double moment(const JenkinsNetwork& network, int n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < network.size(); ++i) {
    sum += network.stiffness()[i] / kStiffness *
           std::pow(kStiffness * network.slip_displacement()[i], n);
  }
  return sum;
}

double total_stiffness(const JenkinsNetwork& network) {
  return kStiffness * moment(network, 0) + network.elastic_stiffness();
}

struct Case {
  std::string name;
  SlipDensity density;
};

/// Densities without atoms.
std::vector<Case> continuous() {
  return {
      {"uniform", SlipDensity({UniformPart{0.0, 30.0, 1.0}})},
      {"uniform above 0", SlipDensity({UniformPart{10.0, 30.0, 0.8}})},
      {"power law", SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}})},
      {"inverse power law", SlipDensity({PowerLawPart{0.1, -1.0, 0.01, 25.0}})},
      {"piecewise linear",
       SlipDensity({PiecewiseLinearPart{{0.0, 4.0, 9.0, 40.0}, {0.05, 0.03, 0.02, 0.0}}})},
      {"gap", SlipDensity({UniformPart{0.0, 5.0, 0.3}, UniformPart{20.0, 30.0, 0.3}})},
  };
}

std::vector<Case> with_atoms() {
  return {
      {"atoms", SlipDensity({AtomsPart{{8.0, 15.0, 30.0}, {0.25, 0.35, 0.3}}})},
      {"four-parameter", SlipDensity({FourParameterPart{30.0, kStiffness, -0.3, 0.2}})},
      {"sum", SlipDensity({UniformPart{0.0, 30.0, 0.4}, AtomsPart{{8.0, 40.0}, {0.2, 0.1}},
                           PowerLawPart{0.02, -0.5, 0.0, 25.0}})},
  };
}

std::vector<Case> all_cases() {
  std::vector<Case> all = continuous();
  for (const Case& one : with_atoms()) all.push_back(one);
  return all;
}

/// The slip force below which the share of the weight is `share`, for a density without atoms.
double quantile(const SlipDensity& density, double share) {
  double low = 0.0;
  double high = density.largest_slip_force();
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (density.moments(middle).zeroth < share * density.total().zeroth ? low : high) = middle;
  }
  return high;
}

// ---- Discretisation. ----

// Φ0, Φ1, Φ2 of the whole survive for any n; Φ1(∞) is the macro-slip force. A single element in a
// bin keeps no Φ2. Sums of up to 1000 terms: 1e-13.
TEST(JenkinsNetwork, KeepsTheMomentsOfTheDensity) {
  for (const auto& [name, density] : all_cases()) {
    const Joint joint(kStiffness, density);
    const std::size_t least = density.atoms().weight.size() + (name == "atoms" ? 0 : 1);
    for (const std::size_t extra : {0U, 1U, 2U, 3U, 10U, 99U, 100U, 1000U}) {
      const std::size_t n = least + extra;
      const JenkinsNetwork network = JenkinsNetwork::discretise(joint, n);
      SCOPED_TRACE(name + ", n = " + std::to_string(n));
      EXPECT_EQ(network.size(), name == "atoms" ? 3U : n);
      EXPECT_NEAR(moment(network, 0), density.total().zeroth, 1e-13);
      EXPECT_NEAR(moment(network, 1), density.total().first, 1e-13 * density.total().first);
      if ((n - density.atoms().weight.size()) % 2 == 0) {
        EXPECT_NEAR(moment(network, 2), density.total().second, 1e-13 * density.total().second);
      }
      EXPECT_DOUBLE_EQ(network.elastic_stiffness(), kStiffness * density.elastic_remainder());
      EXPECT_NEAR(total_stiffness(network), kStiffness, 1e-13 * kStiffness);
      const double end = 1.001 * density.largest_slip_force() / kStiffness;
      EXPECT_NEAR(virgin_force(network, end), joint.virgin_force(end), 1e-13 * kStiffness * end);
      for (const double slip : network.slip_displacement()) {
        EXPECT_GT(slip, 0.0);
        EXPECT_LE(slip, density.largest_slip_force() / kStiffness * (1.0 + 1e-14));
      }
    }
  }
}

// F and D of network and joint agree where kA is at the edge of a bin: with m bins the quantiles
// j/m. The edge here and there differ by a rounding, the bin's moments by that of a difference:
// 1e-13 of the whole.
TEST(JenkinsNetwork, AgreesWithTheJointAtTheEdgesOfItsBins) {
  for (const auto& [name, density] : continuous()) {
    const Joint joint(kStiffness, density);
    for (const std::size_t bins : {1U, 2U, 5U, 50U}) {
      const JenkinsNetwork network = JenkinsNetwork::discretise(joint, 2 * bins);
      for (std::size_t j = 1; j <= bins; ++j) {
        const double share = static_cast<double>(j) / static_cast<double>(bins);
        const double a = quantile(density, share) / kStiffness;
        EXPECT_NEAR(virgin_force(network, a), joint.virgin_force(a), 1e-13 * kStiffness * a)
            << name << ", bin " << j << " of " << bins;
        EXPECT_NEAR(cycle_energy(network, a), dissipation(joint, a), 1e-13 * kStiffness * a * a)
            << name << ", bin " << j << " of " << bins;
      }
    }
  }
}

TEST(JenkinsNetwork, KeepsAtomsAsTheyAre) {
  for (const auto& [name, density] : with_atoms()) {
    const JenkinsNetwork network = JenkinsNetwork::discretise(Joint(kStiffness, density), 51);
    for (std::size_t i = 0; i < density.atoms().weight.size(); ++i) {
      const double slip = density.atoms().slip_force[i] / kStiffness;
      const double stiffness = kStiffness * density.atoms().weight[i];
      bool found = false;
      for (std::size_t j = 0; j < network.size(); ++j) {
        found = found || (std::abs(network.slip_displacement()[j] - slip) <= 1e-15 * slip &&
                          network.stiffness()[j] == stiffness);
      }
      EXPECT_TRUE(found) << name << ", atom " << i;
    }
  }
}

// An atom without weight takes no element from the rest.
TEST(JenkinsNetwork, IgnoresAtomsWithoutWeight) {
  const Joint joint(kStiffness, SlipDensity({UniformPart{0.0, 5.0, 0.5}, AtomsPart{{9.0}, {0.0}}}));
  EXPECT_EQ(JenkinsNetwork::discretise(joint, 1).size(), 1U);
  EXPECT_EQ(JenkinsNetwork::discretise(joint, 10).size(), 10U);
}

TEST(JenkinsNetwork, OfAJointThatNeverSlipsIsASpring) {
  const JenkinsNetwork network = JenkinsNetwork::discretise(Joint(kStiffness, SlipDensity()), 5);
  EXPECT_EQ(network.size(), 0U);
  EXPECT_EQ(network.elastic_stiffness(), kStiffness);
  EXPECT_DOUBLE_EQ(NetworkMemory(network).advance(2e-4), kStiffness * 2e-4);
}

// Parts so narrow that a bin contains only a few numbers: no stiffness is lost and none invented.
TEST(JenkinsNetwork, KeepsTheStiffnessOfNarrowParts) {
  for (const double width : {1e-3, 1e-6, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14}) {
    const SlipDensity density({UniformPart{10.0, 10.0 + width, 0.5}, UniformPart{0.0, 5.0, 0.5}});
    for (const std::size_t n : {1U, 2U, 3U, 10U, 100U, 1000U, 10000U}) {
      const JenkinsNetwork network = JenkinsNetwork::discretise(Joint(kStiffness, density), n);
      EXPECT_LE(network.size(), n);
      EXPECT_NEAR(total_stiffness(network), kStiffness, 1e-10 * kStiffness)
          << width << ", n = " << n;
      EXPECT_NEAR(moment(network, 1), density.total().first, 1e-10) << width << ", n = " << n;
    }
  }
}

// Between the edges F errs by less than the moments of a bin can: of second order in the bin's
// width. Between n and 4n elements that is a factor 16. Where φ falls to 0 linearly, the last of
// the bins of equal weight has a width of order n^-1/2, and the factor is 8.
TEST(JenkinsNetwork, ConvergesWithSecondOrder) {
  for (const auto& [name, density] : all_cases()) {
    if (name == "atoms") continue;
    const Joint joint(kStiffness, density);
    std::vector<double> errors;
    for (const std::size_t n : {22U, 82U, 322U}) {  // 2 of them for atoms where there are
      const std::size_t elements = n - 2 + density.atoms().weight.size();
      const JenkinsNetwork network = JenkinsNetwork::discretise(joint, elements);
      double error = 0.0;
      for (int i = 1; i <= 5000; ++i) {
        const double x = 1.1 * density.largest_slip_force() / kStiffness * i / 5000.0;
        error = std::max(error, std::abs(virgin_force(network, x) - joint.virgin_force(x)));
      }
      errors.push_back(error / joint.macroslip_force());
    }
    const double factor = name == "piecewise linear" ? 7.5 : 14.0;
    EXPECT_GT(errors[0] / errors[1], factor) << name;
    EXPECT_GT(errors[1] / errors[2], factor) << name;
    EXPECT_LT(errors[2], 1e-4) << name;
    RecordProperty(name, ::testing::PrintToString(errors));
  }
}

// The same on random walks, against the exact memory: each open branch adds twice an error of the
// virgin curve at most, so that the whole converges as the curve does.
TEST(JenkinsNetwork, FollowsTheExactMemoryOnRandomWalks) {
  for (const auto& [name, density] : all_cases()) {
    const Joint joint(kStiffness, density);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const std::vector<double> x = random_path(seed, 1000, 5e-4, 3);
      std::vector<double> exact(x.size());
      Memory(joint).march(x, exact);
      std::vector<double> errors;
      for (const std::size_t n : {20U, 100U, 500U}) {
        const JenkinsNetwork network = JenkinsNetwork::discretise(joint, n);
        std::vector<double> force(x.size());
        NetworkMemory(network).march(x, force);
        double error = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
          error = std::max(error, std::abs(force[i] - exact[i]));
        }
        errors.push_back(error / joint.macroslip_force());
      }
      if (name == "atoms") {
        EXPECT_LT(errors[0], 1e-13);  // the same sliders
        continue;
      }
      EXPECT_LT(errors[0], 5e-2) << name;
      EXPECT_LT(errors[1], errors[0] / 10.0) << name;
      EXPECT_LT(errors[2], errors[1] / 10.0) << name;
    }
  }
}

// Both laws are the same model while p = 1; each rounds differently, at 1e-14 N per step at most.
TEST(NetworkMemory, BothLawsAgreeUnderConstantLoad) {
  for (const auto& [name, density] : all_cases()) {
    const Joint joint(kStiffness, density);
    const JenkinsNetwork network = JenkinsNetwork::discretise(joint, 50);
    const std::vector<double> x = random_path(4, 2000, 5e-4, 3);
    const std::vector<double> load(x.size(), 1.0);
    std::vector<double> incremental(x.size());
    std::vector<double> total(x.size());
    NetworkMemory(network, NormalLoadLaw::kIncremental).march(x, incremental);
    NetworkMemory(network, NormalLoadLaw::kTotal).march(x, load, total);
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_NEAR(incremental[i], total[i], 1e-11) << name << ", sample " << i;
    }
  }
}

TEST(NetworkMemory, AdvanceIsWhatMarchDoes) {
  const JenkinsNetwork network =
      JenkinsNetwork::discretise(Joint(kStiffness, SlipDensity({UniformPart{0.0, 30.0, 0.9}})), 21);
  const std::vector<double> x = random_path(5, 300, 5e-4, 2);
  std::vector<double> load(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    load[i] = 1.0 + 0.5 * std::sin(0.1 * static_cast<double>(i));
  for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
    NetworkMemory constant(network, law);
    NetworkMemory varying(network, law);
    std::vector<double> constant_force(x.size());
    std::vector<double> varying_force(x.size());
    NetworkMemory(network, law).march(x, constant_force);
    NetworkMemory(network, law).march(x, load, varying_force);
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_EQ(constant.advance(x[i]), constant_force[i]);
      ASSERT_EQ(varying.advance(x[i], load[i]), varying_force[i]);
    }
  }
}

// ---- The rules. ----

template <typename Function>
std::string message_of(const Function& function) {
  return test::message_or("accepted", function);
}

TEST(JenkinsNetwork, NamesTheElementAndTheRuleItBreaks) {
  using Elements = std::vector<JenkinsElement>;
  const auto message = [](const Elements& elements, double spring = 0.0) {
    return message_of([&] { const JenkinsNetwork network(elements, spring); });
  };
  const std::string positive = "must be positive and finite";
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({{1.0, 1.0}, {0.0, 1.0}}), "elements[1].stiffness = 0; " + positive);
  EXPECT_EQ(message({{nan, 1.0}}), "elements[0].stiffness = nan; " + positive);
  EXPECT_EQ(message({{1.0, -2.0}}), "elements[0].slip_force = -2; " + positive);
  EXPECT_EQ(message({{1.0, 1.0}, {1.0, 1.0}, {1.0, inf}}),
            "elements[2].slip_force = inf; " + positive);
  EXPECT_EQ(message({{1.0, 1.0}}, -1.0), "elastic_stiffness = -1; must be 0 or more, and finite");
  EXPECT_EQ(message({{1.0, 1.0}}, nan), "elastic_stiffness = nan; must be 0 or more, and finite");
  EXPECT_EQ(message({}), "elements = none; a network needs at least one element or a spring");
  EXPECT_EQ(message({}, 1.0), "accepted");
}

TEST(JenkinsNetwork, SaysHowManyElementsADensityNeeds) {
  const auto message = [](const SlipDensity& density, std::size_t n) {
    return message_of([&] { (void)JenkinsNetwork::discretise(Joint(kStiffness, density), n); });
  };
  const std::string rest = " for this density: one per atom, and one for the rest";
  const SlipDensity uniform({UniformPart{0.0, 5.0, 1.0}});
  const SlipDensity both({UniformPart{0.0, 5.0, 0.5}, AtomsPart{{1.0, 2.0}, {0.1, 0.1}}});
  EXPECT_EQ(message(uniform, 0), "number of elements = 0; must be at least 1" + rest);
  EXPECT_EQ(message(both, 2), "number of elements = 2; must be at least 3" + rest);
  EXPECT_EQ(message(uniform, 1), "accepted");
  EXPECT_EQ(message(both, 3), "accepted");
}

TEST(NetworkMemory, RejectsBadPathsBeforeAnyStep) {
  const std::vector<JenkinsElement> elements = {{1.0, 1.0}};
  const JenkinsNetwork network(elements);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> x = {1.0, 2.0, 3.0};
  std::vector<double> force(3);
  NetworkMemory memory(network);
  const auto march = [&](std::vector<double> path, std::vector<double> load) {
    return message_of([&] { memory.march(path, load, force); });
  };
  EXPECT_EQ(march({1.0, nan, 2.0}, {1.0, 1.0, 1.0}), "displacement[1] = nan; must be finite");
  EXPECT_EQ(march(x, {1.0, 1.0}),
            "length of normal_load = 2; must be that of the displacements, 3");
  EXPECT_EQ(march({1.0, 2.0}, {1.0, 1.0}),
            "length of force = 3; must be that of the displacements, 2");
  const std::string rule =
      "must be 0 or more, and finite. "
      "Give the normal load as a ratio to that at which the joint was identified.";
  EXPECT_EQ(march(x, {1.0, 1.0, -0.5}), "normal_load[2] = -0.5; " + rule);
  EXPECT_EQ(march(x, {nan, 1.0, 1.0}), "normal_load[0] = nan; " + rule);
  EXPECT_EQ(message_of([&] {
              memory.march(std::vector<double>{nan, 1.0, 1.0}, force);
            }),
            "displacement[0] = nan; must be finite");
  EXPECT_EQ(memory.advance(0.5), 0.5);  // still virgin
}

}  // namespace
}  // namespace microslip::jenkins_network_test
