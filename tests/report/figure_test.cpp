// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/figure.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/drawing/drawn.hpp"
#include "report/support.hpp"

namespace microslip::figure_test {
namespace {

using test::density_figure;
using test::input_fault;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string fault(const Figure& figure) {
  return input_fault([&] { check_figure(figure); });
}

std::string fault(Layer layer) { return fault(Figure{.layers = {std::move(layer)}}); }

TEST(Figure, AcceptsEveryKindOfLayer) {
  Figure figure = density_figure();
  figure.layers.emplace_back(LoopLayer{.x = {0.0, 1.0}, .y = {0.0, 1.0}});
  EXPECT_EQ(fault(figure), "no error");
}

TEST(FigureFault, Columns) {
  EXPECT_EQ(fault(LineLayer{.x = {1.0, 2.0}, .y = {1.0}}),
            "layers[0].y.size() = 1; must be the 2 of x");
  EXPECT_EQ(fault(LineLayer{}),
            "layers[0].x.size() = 0; must be 1 or more. Leave an empty layer out.");
  EXPECT_EQ(fault(LoopLayer{.x = {1.0, 2.0}, .y = {1.0, kNan}}),
            "layers[0].y[1] = nan; must be finite, at most 1e100 in magnitude");
  EXPECT_EQ(fault(PointLayer{.x = {1.0}, .y = {1.0}, .y_error = {1.0, 2.0}}),
            "layers[0].y_error.size() = 2; must be the 1 of x");
  EXPECT_EQ(fault(PointLayer{.x = {1.0}, .y = {1.0}, .x_error = {-0.5}}),
            "layers[0].x_error[0] = -0.5; must not be negative");
  EXPECT_EQ(fault(BandLayer{.x = {1.0}, .lower = {2.0}, .upper = {1.0}}),
            "layers[0].upper[0] = 1; must not be below lower[0] = 2");
  EXPECT_EQ(fault(LineLayer{.x = {1e101}, .y = {1.0}}),
            "layers[0].x[0] = 1e+101; must be finite, at most 1e100 in magnitude");
}

TEST(FigureFault, Looks) {
  const std::vector<double> one = {1.0};
  EXPECT_EQ(fault(LineLayer{.x = one, .y = one, .stroke = {.colour = -1}}),
            "layers[0].colour = -1; must not be negative");
  EXPECT_EQ(fault(LineLayer{.x = one, .y = one, .stroke = {.width = 0.0}}),
            "layers[0].stroke.width = 0; must be positive and finite");
  EXPECT_EQ(fault(PointLayer{.x = one, .y = one, .size = kNan}),
            "layers[0].size = nan; must be positive and finite");
}

TEST(FigureFault, NothingToDraw) {
  EXPECT_EQ(fault(Figure{}),
            "layers.size() = 0; a figure needs a line, a loop, points, a band or bars");
  EXPECT_EQ(fault(MarkerLayer{.x = 1.0}),
            "layers.size() = 0; a figure needs a line, a loop, points, a band or bars");
  EXPECT_EQ(
      fault(Figure{.y = {.log = true}, .layers = {LineLayer{.x = {1.0, 2.0}, .y = {0.0, -1.0}}}}),
      "layers = no positive value; a logarithmic axis shows positive values only. Make the "
      "axis linear.");
}

TEST(FigureFault, Ranges) {
  Figure figure = density_figure();
  figure.x.range = AxisRange{.from = 2.0, .to = 1.0};
  EXPECT_EQ(fault(figure), "x.range.to = 1; must be larger than range.from = 2");
  figure.x.range = AxisRange{.from = 0.0, .to = 1.0};
  figure.x.log = true;
  EXPECT_EQ(fault(figure), "x.range.from = 0; must be positive on a logarithmic axis");
}

TEST(FigureFault, Grids) {
  EXPECT_EQ(input_fault([] { check_figure(FigureGrid{}); }),
            "panels.size() = 0; must be 1 or more");
  EXPECT_EQ(input_fault([] { check_figure(FigureGrid{.columns = 0, .panels = {{}}}); }),
            "columns = 0; must be 1 or more");
  EXPECT_EQ(input_fault([] {
              check_figure(FigureGrid{.panels = {density_figure(), {}}});
            }),
            "panels[1].layers.size() = 0; a figure needs a line, a loop, points, a band or bars");
}

TEST(DrawnPieces, ALogarithmicAxisBreaksALine) {
  const LineLayer line{.x = {1.0, 2.0, 3.0, 4.0}, .y = {1.0, 0.0, 2.0, 3.0}};
  const std::vector<Piece> pieces = drawn_pieces(line, false, true);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].size(), 1U);
  EXPECT_EQ(pieces[1].size(), 2U);
  EXPECT_EQ(drawn_pieces(line, false, false).size(), 1U);
}

TEST(DrawnPieces, ALoopEndsWhereItBegins) {
  const auto pieces = drawn_pieces(LoopLayer{.x = {1.0, 2.0}, .y = {3.0, 4.0}}, false, false);
  ASSERT_EQ(pieces.at(0).size(), 3U);
  EXPECT_EQ(pieces[0][2].x, 1.0);
  EXPECT_EQ(pieces[0][2].y, 3.0);
}

TEST(DrawnPieces, ABandStaysWhereOnlyItsLowerEdgeIsZero) {
  const BandLayer band{.x = {1.0, 2.0}, .lower = {0.0, 0.0}, .upper = {1.0, 0.0}};
  const auto pieces = drawn_pieces(band, false, true);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), 1U);
}

}  // namespace
}  // namespace microslip::figure_test
