// SPDX-License-Identifier: MIT
#include "microslip/report/rig_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip::rig_figures_test {
namespace {

using Numbers = std::vector<double>;

template <class L>
const L& layer(const Figure& panel, std::size_t i) {
  return std::get<L>(panel.layers.at(i));
}

ReducedLevel level(double response, double amplitude, double input, double linear) {
  ReducedLevel made;
  made.frequency = 55.0;
  made.resonance_frequency = 55.25;
  made.response_amplitude = response;
  made.amplitude.value = amplitude;
  made.input_energy.value = input;
  made.linear_dissipation = linear;
  made.dissipation.value = input - linear;
  return made;
}

/// The second level loses less than the linear damping takes.
std::vector<ReducedLevel> levels() {
  return {level(9.80665, 2e-6, 4e-6, 1e-6), level(19.6133, 4e-6, 1e-6, 2e-6),
          level(29.41995, 8e-6, 5e-4, 1e-4)};
}

void expect_near(const Numbers& found, const Numbers& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-12 * std::abs(expected[i])) << i;  // rounding
  }
}

TEST(ResonanceFigure, DrawsDriveAndResonanceOverTheResponse) {
  const Figure figure = resonance_figure("title", levels());
  EXPECT_EQ(figure.title, "title");
  EXPECT_EQ(figure.x.label, "acceleration amplitude at the exciter [m/s²]");
  EXPECT_EQ(figure.y.label, "frequency [Hz]");
  expect_near(layer<PointLayer>(figure, 0).x, {9.80665, 19.6133, 29.41995});
  EXPECT_EQ(layer<PointLayer>(figure, 0).y, Numbers(3, 55.0));
  EXPECT_EQ(layer<LineLayer>(figure, 1).y, Numbers(3, 55.25));
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(ResonanceFigure, DrawsTheResponseInTheUnitThatIsAskedFor) {
  const Figure figure = resonance_figure("title", levels(), "g");
  EXPECT_EQ(figure.x.label, "acceleration amplitude at the exciter [g]");
  expect_near(layer<LineLayer>(figure, 1).x, {1.0, 2.0, 3.0});
  EXPECT_THROW((void)resonance_figure("title", levels(), "mm"), InputError);
}

TEST(EnergiesFigure, DrawsMillijoulesOverMicrometresWhereTheJointDissipates) {
  const Figure figure = energies_figure("title", levels());
  ASSERT_EQ(figure.layers.size(), 3U);
  EXPECT_TRUE(figure.x.log && figure.y.log);
  EXPECT_EQ(figure.x.label, "joint amplitude A [µm]");
  EXPECT_EQ(figure.y.label, "energy per cycle [mJ]");
  expect_near(layer<LineLayer>(figure, 0).x, {2.0, 8.0});
  expect_near(layer<LineLayer>(figure, 0).y, {4e-3, 0.5});
  expect_near(layer<LineLayer>(figure, 1).y, {1e-3, 0.1});
  expect_near(layer<PointLayer>(figure, 2).y, {3e-3, 0.4});
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(EnergiesFigure, DrawsTheTruthWhereItIsKnown) {
  const Joint truth(1e5, SlipDensity({UniformPart{0.0, 10.0, 1.0}}));
  const Figure figure = energies_figure("title", levels(), &truth);
  ASSERT_EQ(figure.layers.size(), 4U);
  EXPECT_EQ(layer<LineLayer>(figure, 2).legend, "true joint");
  expect_near(layer<LineLayer>(figure, 2).y,
              {1e3 * dissipation(truth, 2e-6), 1e3 * dissipation(truth, 8e-6)});
}

TEST(LinearShareFigure, DrawsPercentOfEveryLevel) {
  const Figure figure = linear_share_figure("title", levels());
  EXPECT_EQ(figure.y.label, "linear loss over input [%]");
  expect_near(layer<LineLayer>(figure, 0).x, {2.0, 4.0, 8.0});
  expect_near(layer<LineLayer>(figure, 0).y, {25.0, 200.0, 20.0});
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
  const Figure history = force_control_figure("title", controlled_levels(), 3).panels.at(0);
  EXPECT_EQ(history.x.label, "time [ms]");
  const auto& before = layer<LineLayer>(history, 0);
  const auto& after = layer<LineLayer>(history, 1);
  const std::size_t half = before.x.size() / 2;
  expect_near({before.x.front(), before.x[half], before.x.back()}, {0.0, 10.0, 20.0});
  expect_near({before.y.front(), before.y[half]}, {8.4, -8.4});
  expect_near({after.y.front(), after.y[half]}, {8.008, -8.008});
}

TEST(ForceControlFigure, DrawsItsHarmonicsInPercentOfTheFirst) {
  const Figure harmonics = force_control_figure("title", controlled_levels(), 3).panels.at(1);
  Numbers heights;
  for (const Layer& bar : harmonics.layers) {
    if (const auto* band = std::get_if<BandLayer>(&bar)) heights.push_back(band->upper.front());
  }
  expect_near(heights, {100.0, 0.0, 5.0, 100.0, 0.0, 0.1});
  EXPECT_EQ(layer<BandLayer>(harmonics, 0).legend, "before control");
  EXPECT_LT(layer<BandLayer>(harmonics, 0).x.back(), 1.0) << "to the left of n = 1";
}

TEST(ForceControlFigure, DrawsTheLargestHarmonicOverTheLevel) {
  const FigureGrid figure = force_control_figure("title", controlled_levels(), 3, "g");
  const Figure& over_level = figure.panels.at(2);
  EXPECT_EQ(over_level.x.label, "acceleration amplitude at the exciter [g]");
  expect_near(layer<LineLayer>(over_level, 1).x, {1.0, 4.0});
  expect_near(layer<LineLayer>(over_level, 1).y, {1.0, 5.0});
  expect_near(layer<LineLayer>(over_level, 2).y, {0.1, 0.1});
  EXPECT_NO_THROW(check_figure(figure));
}

ResponseCurve curve(double response, double force) {
  ResponseCurve made;
  SteadyVibration& point = made.points.emplace_back();
  point.angular_frequency = 100.0 * std::numbers::pi;
  point.response = response;
  point.force_amplitude = force;
  return made;
}

TEST(ConstantResponseFigure, DrawsResponseOverForceAndWhatIsExpectedDotted) {
  const std::vector<NamedResponse> responses{{"1 g", curve(9.0, 2.0), curve(9.0, 3.0)},
                                             {"2 g", curve(18.0, 6.0), {}}};
  const Figure figure = constant_response_figure("title", responses, "m/s²/N");
  EXPECT_EQ(figure.y.label, "response over force [m/s²/N]");
  ASSERT_EQ(figure.layers.size(), 3U) << "nothing is expected of the second";
  const auto& predicted = layer<LineLayer>(figure, 0);
  EXPECT_EQ(predicted.legend, "1 g");
  expect_near(predicted.x, {50.0});
  expect_near(predicted.y, {4.5});
  const auto& expected = layer<LineLayer>(figure, 1);
  EXPECT_EQ(expected.stroke.style, LineStyle::kDotted);
  EXPECT_EQ(expected.legend, "");
  expect_near(expected.y, {3.0});
  EXPECT_NE(layer<LineLayer>(figure, 2).stroke.colour, predicted.stroke.colour);
}

TEST(ForceControlFigure, OfFilesShowsTheHighestLevelAndAll) {
  const std::vector<ForceControlLevel> levels{{"2", 4.0, {0.02, 0.05}, {1e-4, 2e-4}},
                                              {"1", 2.0, {0.01, 0.03}, {1e-5, 2e-5}}};
  const FigureGrid figure = force_control_figure("", levels);
  ASSERT_EQ(figure.panels.size(), 2U);
  Numbers heights;
  for (const Layer& bar : figure.panels[0].layers) {
    if (const auto* band = std::get_if<BandLayer>(&bar)) heights.push_back(band->upper.front());
  }
  expect_near(heights, {100.0, 2.0, 5.0, 100.0, 0.01, 0.02});
  EXPECT_EQ(layer<LineLayer>(figure.panels[1], 1).x, (Numbers{2.0, 4.0}));
  expect_near(layer<LineLayer>(figure.panels[1], 1).y, {3.0, 5.0});
  expect_near(layer<LineLayer>(figure.panels[1], 2).y, {2e-3, 2e-2});
  EXPECT_NO_THROW(check_figure(figure));
  EXPECT_THROW((void)force_control_figure("", std::vector<ForceControlLevel>{}), InputError);
}

}  // namespace
}  // namespace microslip::rig_figures_test
