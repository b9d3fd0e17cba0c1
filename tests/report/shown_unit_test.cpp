// SPDX-License-Identifier: MIT
#include "microslip/report/document/shown_unit.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace microslip::shown_unit_test {
namespace {

TEST(ShownUnit, BringsTheLargestToOneOrMore) {
  EXPECT_EQ(shown_unit("m", 3e-4).text, "µm");
  EXPECT_EQ(shown_unit("m", 2.2e-3).text, "mm");
  EXPECT_EQ(shown_unit("m", 4e-9).text, "nm");
  EXPECT_EQ(shown_unit("J", 8.3e-3).text, "mJ");
  EXPECT_EQ(shown_unit("N/m", 1.7e5).text, "kN/m");
  EXPECT_EQ(shown_unit("N/m", 3e6).text, "MN/m");
  EXPECT_EQ(shown_unit("N/m", 3e12).text, "GN/m");
  EXPECT_EQ(shown_unit("m/N", 6e-3).text, "mm/N");
}

TEST(ShownUnit, LeavesNumbersThatReadWellAlone) {
  for (const double largest : {0.0, 0.1, 1.0, 9999.0}) {
    EXPECT_EQ(shown_unit("N", largest).text, "N") << largest;
    EXPECT_EQ(shown_unit("N", largest).size, 1.0) << largest;
  }
  EXPECT_EQ(shown_unit("N", 0.099).text, "mN");
  EXPECT_EQ(shown_unit("N", 1e4).text, "kN");
}

TEST(ShownUnit, RoundingDoesNotMakeThousandsOfSmallerOnes) {
  EXPECT_EQ(shown_unit("m", 1e-3 * (1.0 - 1e-15)).text, "mm");
}

// In the files and texts of an identification it is in 1/N, too.
TEST(ShownUnit, LeavesADensityInTheUnitOfItsFiles) {
  for (const double largest : {0.0, 4e-6, 0.03, 0.4}) {
    EXPECT_EQ(shown_unit("1/N", largest).text, "1/N") << largest;
    EXPECT_EQ(shown_unit("1/N", largest).size, 1.0) << largest;
  }
}

TEST(ShownUnit, OfOtherUnits) {
  EXPECT_EQ(shown_unit("m/s^2", 1e-5).text, "m/s²");
  EXPECT_EQ(shown_unit("Hz", 1e5).text, "Hz");
  EXPECT_EQ(shown_unit("%", 0.02).size, 0.01);
  EXPECT_NEAR(3.14159265358979 / shown_unit("°", 3.0).size, 180.0, 1e-12);  // rounding
}

TEST(ShowX, ScalesAllLayersBarsAndTheRange) {
  Figure figure;
  figure.x.range = AxisRange{0.0, 4e-4};
  figure.layers = {
      LineLayer{{1e-4}, {1.0}},        PointLayer{.x = {3e-4}, .y = {1.0}, .x_error = {1e-6}},
      BandLayer{{2e-4}, {0.0}, {1.0}}, LoopLayer{{-1e-4}, {1.0}},
      MarkerLayer{.x = 5e-5},
  };
  show_x(figure, "amplitude", "m");
  EXPECT_EQ(axis_text(figure.x), "amplitude [µm]");
  EXPECT_DOUBLE_EQ(figure.x.range->to, 400.0);
  EXPECT_DOUBLE_EQ(std::get<LineLayer>(figure.layers[0]).x[0], 100.0);
  EXPECT_DOUBLE_EQ(std::get<PointLayer>(figure.layers[1]).x[0], 300.0);
  EXPECT_DOUBLE_EQ(std::get<PointLayer>(figure.layers[1]).x_error[0], 1.0);
  EXPECT_DOUBLE_EQ(std::get<BandLayer>(figure.layers[2]).x[0], 200.0);
  EXPECT_DOUBLE_EQ(std::get<LoopLayer>(figure.layers[3]).x[0], -100.0);
  EXPECT_DOUBLE_EQ(std::get<MarkerLayer>(figure.layers[4]).x, 50.0);
  EXPECT_EQ(std::get<LineLayer>(figure.layers[0]).y[0], 1.0);
}

TEST(ShowY, ScalesBandsAndBarsAndLeavesMarkers) {
  Figure figure;
  figure.layers = {
      PointLayer{.x = {1.0}, .y = {2e-3}, .y_error = {1e-4}},
      BandLayer{{1.0}, {1e-3}, {3e-3}},
      MarkerLayer{.x = 5.0},
  };
  show_y(figure, "D", "J");
  EXPECT_EQ(axis_text(figure.y), "D [mJ]");
  EXPECT_DOUBLE_EQ(std::get<PointLayer>(figure.layers[0]).y[0], 2.0);
  EXPECT_DOUBLE_EQ(std::get<PointLayer>(figure.layers[0]).y_error[0], 0.1);
  EXPECT_DOUBLE_EQ(std::get<BandLayer>(figure.layers[1]).lower[0], 1.0);
  EXPECT_DOUBLE_EQ(std::get<BandLayer>(figure.layers[1]).upper[0], 3.0);
  EXPECT_EQ(std::get<MarkerLayer>(figure.layers[2]).x, 5.0);
}

}  // namespace
}  // namespace microslip::shown_unit_test
