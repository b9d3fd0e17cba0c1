// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/release.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/messages.hpp"
#include "support/shaken_chain.hpp"

namespace microslip::release_test {
namespace {

using std::numbers::pi;

/// With joints that stick: a linear structure.
JointedStructure stuck_chain() {
  testing::ShakenChain chain;
  chain.slip_force = {1e6};
  chain.weight = {0.5};
  chain.dashpot = 0.0;
  return chain.modal("m1");
}

// A stuck structure without damping swings in the mode alone, X cos ωt. The joint is marched to
// fourth order: 400 steps per period of the highest mode leave 1e-10.
TEST(Released, ModesSwingByThemselves) {
  const JointedStructure structure = stuck_chain();
  const std::vector<double> stuck = structure.stuck_frequencies();
  for (std::size_t mode = 0; mode < stuck.size(); ++mode) {
    const std::vector<DrawnMode> drawn{{mode, 2e-3}};
    MarchOptions options;
    options.points = {"m3"};
    options.start = released(structure, "m3", drawn);
    LoadHistory loads;
    const double period = 2.0 * pi / stuck[mode];
    options.step = 2.0 * pi / stuck.back() / 400.0;
    for (int i = 0; i <= 40; ++i) loads.time.push_back(period * i / 20.0);
    const MarchResult found = march(structure, loads, options);
    ASSERT_TRUE(found.summary.converged());
    for (std::size_t i = 0; i < loads.time.size(); ++i) {
      EXPECT_NEAR(found.points[0].displacement[i], 2e-3 * std::cos(stuck[mode] * loads.time[i]),
                  1e-8 * 2e-3);
    }
  }
}

TEST(Released, ModesAddUp) {
  const JointedStructure structure = stuck_chain();
  const std::vector<DrawnMode> both{{0, 1e-3}, {2, -4e-4}};
  const InitialState start = released(structure, "m2", both);
  double w = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    w += structure.linear().shape("m2")[i] * start.displacement[i];
  EXPECT_NEAR(w, 6e-4, 1e-15);
}

TEST(Released, NamesWhatIsWrong) {
  const JointedStructure structure = stuck_chain();
  const auto message = [&](std::vector<DrawnMode> drawn, const std::string& point = "m3") {
    return test::message_or("", [&] { return released(structure, point, drawn); });
  };
  test::expect_message(message({{3, 1e-3}}), "mode");
  test::expect_message(message({{0, 1e-3}, {0, 1e-3}}), "mode 1 = twice");
  test::expect_message(message({{0, 0.0}}), "displacement of mode 1");
  test::expect_message(message({{0, 1e-3}}, "m9"), "'m9'");
  const ModalModel still({{1.0, 0.0}, {2.0, 0.0}}, {{"node", {0.0, 1.0}}, {"all", {1.0, 1.0}}});
  const JointedStructure nodal(still, {}, {{"all"}});
  const std::vector<DrawnMode> first{{0, 1e-3}};
  test::expect_message(test::message_or("", [&] { return released(nodal, "node", first); }),
                       "no motion at 'node'");
}

}  // namespace
}  // namespace microslip::release_test
