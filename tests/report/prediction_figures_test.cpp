// SPDX-License-Identifier: MIT
#include "microslip/report/prediction_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "report/support.hpp"

namespace microslip::prediction_figures_test {
namespace {

using test::contains;
using test::input_fault;
using Numbers = std::vector<double>;

const LineLayer& line(const Figure& panel, std::size_t i = 0) {
  return std::get<LineLayer>(panel.layers.at(i));
}

void expect_near(const Numbers& found, const Numbers& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-12 * std::abs(expected[i])) << i;  // rounding
  }
}

TEST(PaperResponse, AtOneForceIsTheDisplacement) {
  const FigureGrid grid = response_figure({{10.0, 11.0}, {0.5, 0.5}, {2e-3, 1e-3}, {0.5, 2.0}});
  ASSERT_EQ(grid.panels.size(), 2U);
  EXPECT_EQ(grid.columns, 1U);
  EXPECT_EQ(axis_text(grid.panels[0].y), "displacement amplitude [mm]");
  EXPECT_TRUE(grid.panels[0].y.log);
  expect_near(line(grid.panels[0]).y, {2.0, 1.0});
  EXPECT_EQ(axis_text(grid.panels[1].y), "phase lag [°]");
  EXPECT_TRUE(grid.panels[1].y.degrees);
  expect_near(line(grid.panels[1]).y, {0.5 * 180.0 / std::numbers::pi, 360.0 / std::numbers::pi});
}

TEST(PaperResponse, AtOneResponseIsOverTheForce) {
  const FigureGrid grid = response_figure({{10.0, 11.0}, {0.5, 0.25}, {1e-3, 1e-3}, {0.5, 2.0}});
  EXPECT_EQ(axis_text(grid.panels[0].y), "displacement over force [mm/N]");
  expect_near(line(grid.panels[0]).y, {2.0, 4.0});
}

TEST(PaperResponse, ThePhaseDoesNotJumpByATurn) {
  const FigureGrid grid =
      response_figure({{10.0, 11.0, 12.0}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, {3.0, -3.0, -0.1}});
  const double degrees = 180.0 / std::numbers::pi;
  expect_near(line(grid.panels[1]).y,
              {3.0 * degrees, 360.0 - 3.0 * degrees, 360.0 - 0.1 * degrees});
}

TEST(PaperBackbone, IsOverTheAmplitude) {
  const PredictedBackbone backbone{{1e-6, 1e-3}, {50.0, 40.0}, {0.01, 0.03}};
  const FigureGrid grid = backbone_figure(backbone);
  EXPECT_EQ(axis_text(grid.panels[0].x), "displacement amplitude [mm]");
  EXPECT_TRUE(grid.panels[0].x.log) << "three decades";
  EXPECT_EQ(line(grid.panels[0]).y, (Numbers{50.0, 40.0}));
  EXPECT_EQ(axis_text(grid.panels[1].y), "damping ratio ζ [%]");
  expect_near(line(grid.panels[1]).y, {1.0, 3.0});
  EXPECT_FALSE(backbone_figure(backbone, {.scale = AmplitudeScale::kLinear}).panels[1].x.log);
}

TEST(PaperDissipationCurve, HasThePanelsOfTheTable) {
  const FigureGrid grid =
      joint_figures(DissipationCurve{{1e-6, 2e-6}, {1e-9, 4e-9}, {1e5, 9e4}, {0.1, 0.2}});
  ASSERT_EQ(grid.panels.size(), 3U);
  EXPECT_FALSE(grid.panels[0].x.log) << "less than a decade";
  expect_near(line(grid.panels[0]).y, {1.0, 4.0});
  EXPECT_EQ(axis_text(grid.panels[0].y), "dissipation per cycle D [nJ]");
  EXPECT_EQ(line(grid.panels[2]).y, (Numbers{0.1, 0.2}));
}

TEST(PaperHistory, HasAPanelAQuantity) {
  const Numbers time{0.0, 1.0};
  const std::vector<HistorySignal> signals{{"drive", "force", "N", time, {1.0, 2.0}},
                                           {"acc1", "acceleration", "m/s^2", time, {3.0, 4.0}},
                                           {"acc2", "acceleration", "m/s^2", time, {5.0, 6.0}},
                                           {"odd", "odd", "", time, {7.0, 8.0}}};
  const FigureGrid grid = histories_figure(signals);
  ASSERT_EQ(grid.panels.size(), 3U);
  EXPECT_EQ(grid.columns, 1U);
  EXPECT_EQ(axis_text(grid.panels[0].y), "force [N]");
  EXPECT_EQ(line(grid.panels[0]).legend, "") << "the axis names it";
  EXPECT_EQ(axis_text(grid.panels[1].y), "acceleration [m/s²]");
  EXPECT_EQ(line(grid.panels[1], 1).legend, "acc2");
  EXPECT_EQ(line(grid.panels[1], 1).y, (Numbers{5.0, 6.0}));
  EXPECT_EQ(axis_text(grid.panels[2].y), "odd [?]");
}

TEST(PaperHistory, TwoUnitsHaveTwoAxes) {
  const Numbers time{0.0, 1.0};
  const std::vector<HistorySignal> signals{{"p", "", "Pa", time, {1.0, 2.0}},
                                           {"e", "", "m/s", time, {3.0, 4.0}},
                                           {"q", "", "Pa", time, {5.0, 6.0}}};
  const FigureGrid grid = histories_figure(signals);
  ASSERT_EQ(grid.panels.size(), 2U);
  EXPECT_EQ(axis_text(grid.panels[0].y), "signal [Pa]");
  EXPECT_EQ(line(grid.panels[0], 1).legend, "q");
  EXPECT_EQ(axis_text(grid.panels[1].y), "velocity [m/s]");
}

TEST(PaperHistory, KeepsPeaksOfALongRecord) {
  constexpr std::size_t kSamples = 100000;
  HistorySignal signal{"force", "force", "N", Numbers(kSamples), Numbers(kSamples, 0.0)};
  for (std::size_t i = 0; i < kSamples; ++i) signal.time[i] = 1e-4 * static_cast<double>(i);
  signal.values[777] = 5.0;
  signal.values[55555] = -3.0;
  const FigureGrid grid = histories_figure(std::vector<HistorySignal>{signal});
  const LineLayer& thin = line(grid.panels[0]);
  EXPECT_LE(thin.x.size(), 4000U);
  const auto peak = std::ranges::max_element(thin.y);
  EXPECT_EQ(*peak, 5.0);
  EXPECT_DOUBLE_EQ(thin.x[static_cast<std::size_t>(peak - thin.y.begin())], 0.0777);
  EXPECT_EQ(std::ranges::min(thin.y), -3.0);
  EXPECT_TRUE(std::ranges::is_sorted(thin.x));
}

TEST(PaperPath, IsForceOverDisplacement) {
  const Figure figure = path_figure({0.0, 1e-4, -1e-4}, {0.0, 5.0, -5.0});
  EXPECT_EQ(axis_text(figure.x), "joint displacement [µm]");
  expect_near(line(figure).x, {0.0, 100.0, -100.0});
}

TEST(PredictionFigures, RefuseWhatIsEmptyOrUneven) {
  EXPECT_TRUE(contains(input_fault([] { return response_figure({}); }), "x.size() = 0"));
  EXPECT_TRUE(contains(input_fault([] {
                         return backbone_figure({{1.0}, {1.0, 2.0}, {1.0}});
                       }),
                       "y.size() = 2"));
  EXPECT_TRUE(contains(input_fault([] { return histories_figure({}); }), "needs a signal"));
  EXPECT_TRUE(contains(input_fault([] { return path_figure({1.0}, {}); }), "y.size() = 0"));
}

}  // namespace
}  // namespace microslip::prediction_figures_test
