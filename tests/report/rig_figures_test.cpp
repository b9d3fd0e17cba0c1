// SPDX-License-Identifier: MIT
#include "microslip/report/figures/rig_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::rig_figures_test {
namespace {

using Numbers = std::vector<double>;

template <class L>
const L& layer(const Figure& panel, std::size_t i) {
  return std::get<L>(panel.layers.at(i));
}

void expect_near(const Numbers& found, const Numbers& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-12 * std::abs(expected[i])) << i;  // rounding
  }
}

/// 50 Hz; 8 cos θ, and `third` cos 3θ.
DrivenVibration driven(double third) {
  DrivenVibration made;
  made.vibration.angular_frequency = 100.0 * std::numbers::pi;
  made.force = {0.0, 8.0, 0.0, third};
  return made;
}

std::vector<VirtualLevel> controlled_levels() {
  std::vector<VirtualLevel> made(2);
  made[0].response = 9.80665;
  made[1].response = 39.2266;
  made[0].uncontrolled = driven(0.08);
  made[1].uncontrolled = driven(0.4);
  for (VirtualLevel& one : made) one.controlled = driven(0.008);
  return made;
}

TEST(ForceControlFigure, DrawsTheForceOfTheHighestLevelOverACycle) {
  const Figure history = force_control_figure(controlled_levels(), 3).panels.at(0);
  EXPECT_EQ(axis_text(history.x), "time [ms]");
  const auto& before = layer<LineLayer>(history, 0);
  const auto& after = layer<LineLayer>(history, 1);
  const std::size_t half = before.x.size() / 2;
  expect_near({before.x.front(), before.x[half], before.x.back()}, {0.0, 10.0, 20.0});
  expect_near({before.y.front(), before.y[half]}, {8.4, -8.4});
  expect_near({after.y.front(), after.y[half]}, {8.008, -8.008});
}

TEST(ForceControlFigure, DrawsItsHarmonicsInPercentOfTheFirst) {
  const Figure harmonics = force_control_figure(controlled_levels(), 3).panels.at(1);
  EXPECT_EQ(harmonics.title, "Harmonics of the force at 39.2 m/s²");
  expect_near(layer<BarLayer>(harmonics, 0).x, {2.0, 3.0});
  expect_near(layer<BarLayer>(harmonics, 0).y, {0.0, 5.0});
  expect_near(layer<BarLayer>(harmonics, 1).y, {0.0, 0.1});
  EXPECT_EQ(layer<BarLayer>(harmonics, 0).legend, "before control");
}

TEST(ForceControlFigure, DrawsTheLargestHarmonicOverTheLevel) {
  const FigureGrid figure = force_control_figure(controlled_levels(), 3, {.response_unit = "g"});
  const Figure& over_level = figure.panels.at(2);
  EXPECT_EQ(axis_text(over_level.x), "exciter acceleration [g]");
  expect_near(layer<LineLayer>(over_level, 0).y, {1.0, 1.0});  // the limit
  expect_near(layer<PointLayer>(over_level, 1).x, {1.0, 4.0});
  expect_near(layer<PointLayer>(over_level, 1).y, {1.0, 5.0});
  expect_near(layer<PointLayer>(over_level, 2).y, {0.1, 0.1});
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(ForceControlFigure, OfFilesShowsTheHighestLevelAndAll) {
  const std::vector<ForceControlLevel> levels{{"2", 4.0, {0.02, 0.05}, {1e-4, 2e-4}},
                                              {"1", 2.0, {0.01, 0.03}, {1e-5, 2e-5}}};
  const FigureGrid figure = force_control_figure(levels);
  ASSERT_EQ(figure.panels.size(), 2U);
  expect_near(layer<BarLayer>(figure.panels[0], 0).y, {2.0, 5.0});
  expect_near(layer<BarLayer>(figure.panels[0], 1).y, {0.01, 0.02});
  EXPECT_EQ(layer<PointLayer>(figure.panels[1], 1).x, (Numbers{4.0, 2.0}));
  expect_near(layer<PointLayer>(figure.panels[1], 1).y, {5.0, 3.0});
  expect_near(layer<PointLayer>(figure.panels[1], 2).y, {2e-2, 2e-3});
  EXPECT_NO_THROW(check_figure(figure));
  EXPECT_THROW((void)force_control_figure(std::vector<ForceControlLevel>{}), InputError);
}

}  // namespace
}  // namespace microslip::rig_figures_test
