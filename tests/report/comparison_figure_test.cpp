// SPDX-License-Identifier: MIT
#include "microslip/report/figures/comparison_figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "report/support.hpp"

namespace microslip::comparison_figure_test {
namespace {

/// Three values, the middle one outside of its band, and the peak beside them.
ComparedTest sweep(const std::string& source) {
  const auto curve = [](const std::string& quantity, const Dimension& dimension, TestPart part) {
    return ComparedCurve{.quantity = quantity,
                         .dimension = dimension,
                         .part = part,
                         .axis = "frequency",
                         .axis_dimension = kFrequency};
  };
  ComparedCurve along = curve("displacement", kLength, TestPart::kCurve);
  along.at = {12.0, 10.0, 11.0};  // in no order
  along.measured = {1e-4, 1e-4, 5e-4};
  along.measured_std = {1e-5, std::numeric_limits<double>::quiet_NaN(), 1e-5};
  along.predicted = {1.1e-4, 0.9e-4, 3e-4};
  along.lower = {0.5e-4, 0.5e-4, 2e-4};
  along.upper = {2e-4, 2e-4, 4e-4};
  ComparedCurve height = curve("displacement", kLength, TestPart::kPeak);
  height.at = {11.1};
  height.measured = {5.1e-4};
  height.predicted = {3.1e-4};
  ComparedCurve frequency = curve("frequency", kFrequency, TestPart::kPeak);
  frequency.at = frequency.measured = {11.1};
  frequency.predicted = {10.9};
  return {.source = source, .curves = {along, height, frequency}};
}

const PointLayer* points(const Figure& panel, const std::string& legend) {
  for (const Layer& layer : panel.layers) {
    const auto* found = std::get_if<PointLayer>(&layer);
    if (found != nullptr && found->legend == legend) return found;
  }
  return nullptr;
}

TEST(ComparisonFigure, TellsInsideFromOutsideAndShowsThePeak) {
  const std::vector<ComparedTest> tests{sweep("one"), sweep("two")};
  const FigureGrid grid = comparison_figure(tests);
  ASSERT_EQ(grid.panels.size(), 2U);
  EXPECT_EQ(grid.columns, 1U);
  const Figure& panel = grid.panels[1];
  EXPECT_EQ(panel.title, "two");
  EXPECT_EQ(axis_text(panel.y), "displacement [µm]");
  const PointLayer* inside = points(panel, "measured, inside");
  const PointLayer* outside = points(panel, "measured, outside");
  ASSERT_TRUE(inside != nullptr && outside != nullptr);
  EXPECT_EQ(inside->x, (std::vector<double>{10.0, 12.0}));
  EXPECT_EQ(outside->x, std::vector<double>{11.0});
  EXPECT_NEAR(outside->y_error.front(), 10.0, 1e-9);
  EXPECT_NE(inside->colour, outside->colour);
  const PointLayer* peak = points(panel, "predicted peak");
  ASSERT_NE(peak, nullptr);
  EXPECT_EQ(peak->x, std::vector<double>{10.9});
  check_figure(grid);
}

TEST(ComparisonFigure, ShowsSomeOfVeryManyAndTheLoopOfARecord) {
  std::vector<ComparedTest> tests(20, sweep("many"));
  EXPECT_EQ(comparison_figure(tests).panels.size(), kMostComparedTests);
  ComparedTest record = sweep("record");
  record.loop = {{-1e-3, 0.0, 1e-3}, {-1.0, 0.0, 1.0}, {-1.0, 0.1, 1.0}};
  const FigureGrid grid = comparison_figure(std::vector<ComparedTest>{record});
  ASSERT_EQ(grid.panels.size(), 2U);
  EXPECT_EQ(grid.columns, 2U);
  EXPECT_EQ(axis_text(grid.panels[0].y), "force [N]");
}

TEST(ComparisonFigure, NeedsAPrediction) {
  ComparedTest test = sweep("none");
  test.curves[0].predicted.assign(3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(test::contains(
      test::input_fault([&] { return comparison_figure(std::vector<ComparedTest>{test}); }),
      "compared tests"));
}

}  // namespace
}  // namespace microslip::comparison_figure_test
