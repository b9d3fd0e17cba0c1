// SPDX-License-Identifier: MIT
#include "microslip/report/figures/prediction_figures.hpp"

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

// With a shaken base the axes name the reference of the displacement and the divisor.
TEST(PaperResponse, OfAShakenBaseSaysSo) {
  const FigureGrid kept =
      response_figure({{10.0, 11.0}, {0.5, 0.5}, {2e-3, 1e-3}, {0.5, 2.0}, {}, true});
  EXPECT_EQ(axis_text(kept.panels[0].y), "amplitude relative to the base [mm]");
  const FigureGrid over =
      response_figure({{10.0, 11.0}, {0.5, 0.25}, {1e-3, 1e-3}, {0.5, 2.0}, {}, true});
  EXPECT_EQ(axis_text(over.panels[0].y), "displacement over base acceleration [s²]");
  expect_near(line(over.panels[0]).y, {2e-3, 4e-3});
}

TEST(PaperResponse, ThePhaseDoesNotJumpByATurn) {
  const FigureGrid grid =
      response_figure({{10.0, 11.0, 12.0}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, {3.0, -3.0, -0.1}});
  const double degrees = 180.0 / std::numbers::pi;
  expect_near(line(grid.panels[1]).y,
              {3.0 * degrees, 360.0 - 3.0 * degrees, 360.0 - 0.1 * degrees});
}

// ---- Bands of draws. ----

const BandLayer& band(const Figure& panel, std::size_t i = 0) {
  return std::get<BandLayer>(panel.layers.at(i));
}

// Behind the curve, in its unit; at one response a band of the force is turned over.
TEST(BandOfDraws, LiesBehindAResponse) {
  PredictedResponse response{{10.0, 11.0}, {0.5, 0.5}, {2e-3, 1e-3}, {0.5, 2.0}};
  response.band = {{1e-3, 0.5e-3}, {3e-3, 2e-3}};
  const FigureGrid at_force = response_figure(response);
  expect_near(band(at_force.panels[0]).upper, {3.0, 2.0});
  expect_near(line(at_force.panels[0], 1).y, {2.0, 1.0});
  EXPECT_EQ(at_force.panels[1].layers.size(), 1U);
  PredictedResponse kept{{10.0, 11.0}, {0.5, 0.25}, {1e-3, 1e-3}, {0.5, 2.0}};
  kept.band = {{0.25, 0.2}, {1.0, 0.5}};
  const FigureGrid at_response = response_figure(kept);
  expect_near(band(at_response.panels[0]).lower, {1.0, 2.0});
  expect_near(band(at_response.panels[0]).upper, {4.0, 5.0});
}

// An area is one between two lines over x: where the curve turns back another begins.
TEST(BandOfDraws, HasAPartBetweenTwoTurns) {
  PredictedResponse response{
      {10.0, 12.0, 11.0, 13.0}, {1.0, 1.0, 1.0, 1.0}, {1.0, 4.0, 3.0, 2.0}, {0.1, 0.2, 0.3, 0.4}};
  response.band = {{0.5, 3.5, 2.5, 1.5}, {1.5, 4.5, 3.5, 2.5}};
  const Figure panel = response_figure(response).panels[0];
  ASSERT_EQ(panel.layers.size(), 4U);
  EXPECT_EQ(band(panel, 0).x, (Numbers{10.0, 12.0}));
  EXPECT_EQ(band(panel, 1).x, (Numbers{12.0, 11.0}));
  EXPECT_EQ(band(panel, 2).x, (Numbers{11.0, 13.0}));
  EXPECT_EQ(band(panel, 1).legend, band(panel, 2).legend);
}

TEST(BandOfDraws, LiesBehindBackboneJointAndPath) {
  const FigureGrid backbone =
      backbone_figure({{1.0, 2.0}, {55.0, 54.0}, {0.01, 0.02}, {{54.0, 53.0}, {56.0, 55.0}}, {}});
  EXPECT_EQ(band(backbone.panels[0]).lower, (Numbers{54.0, 53.0}));
  EXPECT_EQ(backbone.panels[1].layers.size(), 1U);
  DissipationCurve curve{{1.0, 2.0}, {1.0, 3.0}, {10.0, 9.0}, {0.1, 0.2}};
  curve.loss_band = {{0.05, 0.1}, {0.2, 0.3}};
  EXPECT_EQ(band(joint_figures(curve).panels[2]).upper, (Numbers{0.2, 0.3}));
  const Figure path =
      path_figure({0.0, 1.0, 0.5}, {0.0, 2.0, 1.0}, {{0.0, 1.5, 0.5}, {0.0, 2.5, 1.5}});
  ASSERT_EQ(path.layers.size(), 3U);
  EXPECT_EQ(band(path, 1).x, (Numbers{1.0, 0.5}));
}

// A long history is drawn by parts: of each the widest band.
TEST(BandOfDraws, OfALongHistoryIsTheWidestOfEachPart) {
  HistorySignal signal{"displacement", "displacement", "m", {}, {}};
  constexpr std::size_t kCount = 20'000;
  for (std::size_t i = 0; i < kCount; ++i) {
    signal.time.push_back(static_cast<double>(i));
    signal.values.push_back(0.0);
    signal.band.lower.push_back(i == 5 ? -2.0 : -1.0);
    signal.band.upper.push_back(i == kCount - 1 ? 3.0 : 1.0);
  }
  const std::vector<HistorySignal> signals{signal};
  const Figure panel = histories_figure(signals).panels[0];
  ASSERT_EQ(panel.layers.size(), 2U);
  EXPECT_EQ(band(panel).x.size(), 4000U);
  EXPECT_EQ(std::ranges::min(band(panel).lower), -2.0);
  EXPECT_EQ(std::ranges::max(band(panel).upper), 3.0);
  EXPECT_TRUE(line(panel, 1).legend.empty());
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

// Curves have a panel each, in units that read well; numbers alone are no figure.
TEST(EnsembleFigure, HasThePanelsOfTheCurves) {
  const Numbers at{0.0, 1.0, 2.0, 3.0};
  EnsembleCurve curve{"low", "slip_density", "1/N", "slip_force", "N", at, {4, 3, 2, 1}};
  curve.band = {{3, 2, 1, 0}, {5, 4, 3, 2}};
  const EnsembleCurve number{"low", "area", "1", "", "", {0.0}, {0.5}};
  const FigureGrid grid = ensemble_figure(std::vector<EnsembleCurve>{number, curve});
  ASSERT_EQ(grid.panels.size(), 1U);
  EXPECT_EQ(axis_text(grid.panels[0].x), "slip force [N]");
  EXPECT_EQ(axis_text(grid.panels[0].y), "slip density [1/N]");
  EXPECT_EQ(std::get<BandLayer>(grid.panels[0].layers[0]).upper, (Numbers{5, 4, 3, 2}));
  EXPECT_EQ(line(grid.panels[0], 1).y, (Numbers{4, 3, 2, 1}));
  EXPECT_TRUE(
      contains(input_fault([&] { return ensemble_figure(std::vector<EnsembleCurve>{number}); }),
               "numbers alone"));
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
