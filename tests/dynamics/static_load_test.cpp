// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/dynamics/structure/static_equilibrium.hpp"
#include "microslip/joint/memory.hpp"
#include "support/messages.hpp"
#include "support/shaken_chain.hpp"

/// @file Loads that always act, and vibrations about where they hold a structure.

namespace microslip::static_load_test {
namespace {

using std::numbers::pi;
using testing::ShakenChain;

constexpr double kPreload = 12.0;  // N on m3: the joint carries most of it, three of its atoms slip

/// Displacements of the masses from those of modes.
std::array<double, 3> masses(const JointedStructure& structure, const std::vector<double>& q) {
  std::array<double, 3> x{};
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t i = 0; i < 3; ++i) x[p] += structure.linear().points()[p].shape[i] * q[i];
  }
  return x;
}

// In a row of springs each carries the whole load, whatever the joint parallel to one of them does.
TEST(StaticLoad, IsCarriedByTheChainAsByHand) {
  const ShakenChain chain;
  const JointedStructure structure = chain.modal("m1", {{"m3", kPreload}});
  const StaticEquilibrium found = static_equilibrium(structure);
  const std::array<double, 3> x = masses(structure, found.modal);
  EXPECT_NEAR(chain.spring[0] * x[0], kPreload, 1e-9);
  EXPECT_NEAR(chain.spring[2] * (x[2] - x[1]), kPreload, 1e-9);
  const double u = x[1] - x[0];
  double force = 0.0;  // of the sliders, each by itself
  double elastic = 1.0;
  for (std::size_t s = 0; s < chain.weight.size(); ++s) {
    force += chain.weight[s] * std::min(chain.stiffness * u, chain.slip_force[s]);
    elastic -= chain.weight[s];
  }
  force += elastic * chain.stiffness * u;
  EXPECT_NEAR(chain.spring[1] * u + force, kPreload, 1e-9);
  EXPECT_NEAR(found.joint_displacement[0], u, 1e-15);
  EXPECT_NEAR(found.joint_force[0], force, 1e-9);
}

// A weight is the acceleration of the support against it.
TEST(StaticLoad, OfABaseIsThatOfTheWeights) {
  const ShakenChain chain;
  const double g = 9.81;
  const StaticEquilibrium by_base = static_equilibrium(chain.modal("m1", {{"table", -g}}));
  const StaticEquilibrium by_weights = static_equilibrium(chain.modal(
      "m1", {{"m1", chain.mass[0] * g}, {"m2", chain.mass[1] * g}, {"m3", chain.mass[2] * g}}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(by_base.modal[i], by_weights.modal[i], 1e-12 * std::abs(by_weights.modal[0]));
  }
}

// With a compliance in series and half of the normal load: u + cpF(u) is the displacement of its
// ends.
TEST(StaticLoad, KnowsWhatLiesInSeriesAndTheNormalLoad) {
  const ShakenChain chain;
  const JointedStructure plain = chain.modal("m1", {{"m3", kPreload}});
  std::vector<StructuralJoint> joints(plain.joints().begin(), plain.joints().end());
  joints[0].series_compliance = 3e-5;
  const JointedStructure structure = plain.with_joints(joints);
  const std::vector<double> load{0.5};
  const StaticEquilibrium found = static_equilibrium(structure, load);
  const std::array<double, 3> x = masses(structure, found.modal);
  const double u = found.joint_displacement[0];
  EXPECT_NEAR(found.joint_force[0], 0.5 * joints[0].joint.virgin_force(u), 1e-12);
  EXPECT_NEAR(u + 3e-5 * found.joint_force[0], x[1] - x[0], 1e-14);
  EXPECT_NEAR(chain.spring[1] * (x[1] - x[0]) + found.joint_force[0], kPreload, 1e-9);
}

// A joint that may slip without limit, and a body that floats, are reported with the load.
TEST(StaticLoad, WithoutAnEquilibriumIsAnError) {
  const ModalModel body({{0.0, 0.0}}, {{"mass", {1.0}}});
  const Joint joint(1e4, SlipDensity({UniformPart{0.0, 4.0, 1.0}}));
  const auto message = [&](double force, std::vector<StructuralJoint> joints) {
    const JointedStructure structure(body, std::move(joints), {{"mass"}}, DampingLaw::kViscous,
                                     {{"mass", force}});
    return test::message_or("", [&] { return static_equilibrium(structure); });
  };
  EXPECT_EQ(message(1.9, {{"joint", joint, {1.0}}}), "");
  test::expect_message(message(2.1, {{"joint", joint, {1.0}}}), "2.1 N at 'mass'");
  test::expect_message(message(0.1, {}), "must have an equilibrium");
}

// March of a burst about the preload, against the integration in physical coordinates from the same
// place: 1e-4 as for shaken supports.
TEST(StaticLoad, IsWhereAMarchBegins) {
  const ShakenChain chain;
  const JointedStructure structure = chain.modal("m1", {{"m3", kPreload}});
  LoadHistory loads{{}, {{"m1", {}}}};
  constexpr double kBetween = 1e-3;
  for (int i = 0; i <= 600; ++i) {
    loads.time.push_back(kBetween * i);
    loads.forces[0].force.push_back(i < 200 ? 25.0 * std::sin(2.0 * pi * 15.0 * kBetween * i)
                                            : 0.0);
  }
  MarchOptions options;
  options.points = {"m3"};
  const MarchResult found = march(structure, loads, options);
  ASSERT_TRUE(found.summary.converged()) << found.summary.full();

  const auto at = [&](double t) {
    const auto k = std::min<std::size_t>(static_cast<std::size_t>(t / kBetween), 599);
    const std::vector<double>& f = loads.forces[0].force;
    const double share = (t - loads.time[k]) / kBetween;
    return ShakenChain::Acting{.force = {f[k] + share * (f[k + 1] - f[k]), 0.0, kPreload}};
  };
  const std::array<double, 3> begin = masses(structure, static_equilibrium(structure).modal);
  ShakenChain::State start;
  start.x = begin;
  constexpr double kFine = 5e-6;
  const auto per_row = static_cast<std::size_t>(std::llround(kBetween / kFine));
  std::size_t step = 0;
  double miss = 0.0;
  double largest = 0.0;  // of the motion about the preload
  chain.integrate(at, start, 0.6, kFine, [&](double, const ShakenChain::State& state) {
    if (++step % per_row != 0) return;
    miss = std::max(miss, std::abs(found.points[0].displacement.at(step / per_row) - state.x[2]));
    largest = std::max(largest, std::abs(state.x[2] - begin[2]));
  });
  EXPECT_LT(miss, 1e-4 * largest);
  EXPECT_NEAR(found.points[0].displacement[0], begin[2], 1e-12 * begin[2]);
}

// Steady vibration about the preload: the mean and the first harmonic of a march from there that
// grows over 240 periods. Where it begins faster, over 60, it overshoots, and the mean is another
// by 4e-4 of the vibration: it is what the joints remember of the largest cycle.
TEST(StaticLoad, ShiftsSteadyVibrations) {
  const ShakenChain chain;
  const JointedStructure structure = chain.modal("m1", {{"m3", kPreload}});
  const HarmonicBalance balance(structure, {"m3"}, {.harmonics = 15, .samples = 512});
  const double omega = 2.0 * pi * 14.0;
  const auto found =
      balance.solve({Quantity::kAngularFrequency, omega}, {Quantity::kForceAmplitude, 9.0});
  ASSERT_TRUE(found.summary.converged()) << found.summary.full();

  constexpr int kPerPeriod = 400;
  constexpr int kPeriods = 400;
  LoadHistory loads{{}, {{"m1", {}}}};
  for (int i = 0; i <= kPeriods * kPerPeriod; ++i) {
    loads.time.push_back(2.0 * pi / omega * i / kPerPeriod);
    const double grown =
        std::min(1.0, static_cast<double>(i) / (240.0 * kPerPeriod));  // no overshoot
    loads.forces[0].force.push_back(9.0 * grown * std::cos(omega * loads.time.back()));
  }
  MarchOptions options;
  options.points = {"m3"};
  options.estimate_error = false;
  const MarchResult marched = march(structure, loads, options);
  ASSERT_TRUE(marched.summary.converged()) << marched.summary.full();
  std::complex<double> first = 0.0;
  double mean = 0.0;
  for (int i = (kPeriods - 1) * kPerPeriod; i < kPeriods * kPerPeriod; ++i) {
    const double w = marched.points[0].displacement[static_cast<std::size_t>(i)];
    mean += w / kPerPeriod;
    first +=
        2.0 / kPerPeriod * w * std::polar(1.0, -omega * loads.time[static_cast<std::size_t>(i)]);
  }
  const auto w = found.vibration.displacement(structure.linear(), "m3");
  EXPECT_LT(std::abs(w.at(1) - first), 2e-4 * std::abs(first));
  EXPECT_NEAR(w.at(0).real(), mean, 2e-4 * std::abs(first));
  // Without the preload it is another motion: the joint stands elsewhere.
  const HarmonicBalance bare(chain.modal("m1"), {"m3"}, {.harmonics = 15, .samples = 512});
  const auto without =
      bare.solve({Quantity::kAngularFrequency, omega}, {Quantity::kForceAmplitude, 9.0});
  EXPECT_NEAR(std::abs(without.vibration.displacement(structure.linear(), "m3").at(0)), 0.0, 1e-12);
}

// Curves begin and go on about the preload.
TEST(StaticLoad, LetsCurvesBeFollowed) {
  const ShakenChain chain;
  const HarmonicBalance balance(chain.modal("m1", {{"m3", kPreload}}), {"m3"});
  const ResponseCurve curve = balance.frequency_response(5.0, 2.0 * pi * 8.0, 2.0 * pi * 20.0);
  EXPECT_TRUE(curve.summary.converged()) << curve.summary.full();
  EXPECT_EQ(curve.peaks.size(), 1U);
  const std::vector<double> levels{1e-5, 1e-4, 1e-3};
  const ResponseCurve backbone = balance.resonances(levels);
  EXPECT_TRUE(backbone.summary.converged()) << backbone.summary.full();
  EXPECT_EQ(backbone.points.size(), 3U);
  for (const SteadyVibration& point : curve.points) EXPECT_LT(point.energy_imbalance, 1e-7);
}

// A vibration of 2e-5 to 6e-2 of what the preload displaces, whose second harmonic meets a mode:
// rounding of the rest is hundreds of times larger there. The curve is found all the same, without
// a gap, and is that of ten times the force but for the slip of that: 1.1 % at its peak.
TEST(StaticLoad, LeavesSmallVibrationsToBeFound) {
  const Joint joint(2e5, SlipDensity({UniformPart{0.0, 50.0, 0.9}}));
  const JointedStructure structure(
      ModalModel({{2.0 * pi * 16.0, 0.004}, {2.0 * pi * 28.0, 0.004}},
                 {{"first", {0.707, 0.707}}, {"second", {0.707, -0.707}}}),
      {{"lap", joint, {0.3, 1.414}}}, {{"first"}}, DampingLaw::kViscous, {{"second", 40.0}});
  const HarmonicBalance balance(structure, {"first"});
  const auto curve = [&](double force) {
    return balance.frequency_response(force, 2.0 * pi * 10.0, 2.0 * pi * 50.0);
  };
  const ResponseCurve small = curve(0.01);
  EXPECT_TRUE(small.summary.converged()) << small.summary.full();
  EXPECT_TRUE(small.warnings.empty()) << small.warnings.front().text;
  ASSERT_EQ(small.peaks.size(), 1U);
  const double rest = std::abs(static_equilibrium(structure).joint_displacement[0]);
  EXPECT_LT(small.peaks[0].joints[0].amplitude, 0.06 * rest);
  const ResponseCurve large = curve(0.1);
  ASSERT_EQ(large.peaks.size(), 1U);
  EXPECT_NEAR(10.0 * small.peaks[0].response, large.peaks[0].response,
              0.02 * large.peaks[0].response);
}

// What floats freely may be preloaded in itself, or beside: only a load on what nothing holds has
// no equilibrium.
TEST(StaticLoad, OfAFloatingStructureMayBeInBalance) {
  const ModalModel linear({{0.0, 0.0}, {100.0, 0.01}},
                          {{"left", {0.5, 0.5}}, {"right", {0.5, -0.5}}});
  const auto with = [&](std::vector<StaticLoad> loads) {
    return JointedStructure(linear, {}, {{"left"}}, DampingLaw::kViscous, std::move(loads));
  };
  const StaticEquilibrium found = static_equilibrium(with({{"left", 40.0}, {"right", -40.0}}));
  EXPECT_NEAR(found.modal[1], 40.0 / 1e4, 1e-15);
  EXPECT_NEAR(found.modal[0], 0.0, 1e-15);
  test::expect_message(test::message_or("",
                                        [&] {
                                          return static_equilibrium(with({{"left", 40.0}}));
                                        }),
                       "must have an equilibrium");
}

// The error of a march is that of the motion about the preload, which is some hundred times as
// large here and hides nothing. The first step alone is cut otherwise, as the joint has been moved
// before: a third of the error is room enough for that, and none for a hundredth.
TEST(StaticLoad, DoesNotHideTheErrorOfAMarch) {
  testing::ShakenChain chain;
  chain.slip_force = {1e6};  // sticks, so that the motion is the same about every preload
  LoadHistory loads{{}, {{"m1", {}}}};
  for (int i = 0; i <= 40; ++i) {
    loads.time.push_back(0.02 * i);
    loads.forces[0].force.push_back(i % 2 == 0 ? 20.0 : -20.0);
  }
  chain.weight = {0.9};
  MarchOptions options;
  options.points = {"m3"};
  options.step = 5e-3;
  const MarchResult bare = march(chain.modal("m1"), loads, options);
  const MarchResult held = march(chain.modal("m1", {{"m3", 4e2}}), loads, options);
  ASSERT_TRUE(bare.error_estimate && held.error_estimate);
  EXPECT_NEAR(*held.error_estimate / *bare.error_estimate, 1.0, 0.3);
  EXPECT_GT(*bare.error_estimate, 0.0);
}

}  // namespace
}  // namespace microslip::static_load_test
