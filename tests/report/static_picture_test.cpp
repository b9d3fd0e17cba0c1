// SPDX-License-Identifier: MIT
#include "microslip/report/document/static_picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/report/drawing/legend_layout.hpp"

namespace microslip::static_picture_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ReportFigure figure_with(std::vector<Layer> layers) {
  return {.figure = {.title = "Loss",
                     .x = {.label = "amplitude A", .unit = "µm", .log = true},
                     .y = {.label = "D", .unit = "mJ", .range = AxisRange{0.0, 5.0}},
                     .layers = std::move(layers)}};
}

TEST(StaticPicture, HasTheAxesAndNoHeading) {
  const Figure picture = static_picture(figure_with({LineLayer{{1.0}, {1.0}, "a"}}));
  EXPECT_EQ(axis_text(picture.x), "amplitude A [µm]");
  EXPECT_TRUE(picture.x.log);
  ASSERT_TRUE(picture.y.range.has_value());
  EXPECT_EQ(picture.y.range->to, 5.0);
  EXPECT_EQ(picture.title, "");
}

TEST(StaticPicture, IsOfWhatIsChosen) {
  ReportFigure figure = figure_with({});
  figure.choices = {{"one", {LineLayer{{1.0}, {1.0}, "a"}}},
                    {"two", {LineLayer{{2.0}, {1.0}, "b"}}}};
  figure.chosen = 1;
  const Figure picture = static_picture(figure);
  ASSERT_EQ(picture.layers.size(), 1);
  EXPECT_EQ(legend_of(picture.layers[0]), "b");
}

TEST(StaticPicture, AGapSplitsALineThatStaysOneInTheLegend) {
  const Figure picture =
      static_picture(figure_with({LineLayer{{1.0, 2.0, 3.0, 4.0}, {1.0, kNan, 3.0, 4.0}, "a"}}));
  ASSERT_EQ(picture.layers.size(), 2);
  const auto& first = std::get<LineLayer>(picture.layers[0]);
  const auto& second = std::get<LineLayer>(picture.layers[1]);
  EXPECT_EQ(first.x, (std::vector{1.0}));
  EXPECT_EQ(second.y, (std::vector{3.0, 4.0}));
  EXPECT_EQ(legend_texts(picture, 300.0).size(), 1);
}

TEST(StaticPicture, EveryKindOfLayer) {
  const Figure picture = static_picture(figure_with({
      BandLayer{.x = {1.0}, .lower = {0.0}, .upper = {2.0}, .legend = "band"},
      LoopLayer{.x = {1.0}, .y = {1.0}, .legend = "loop"},
      PointLayer{.x = {1.0, 2.0}, .y = {kNan, 1.0}, .y_error = {0.1, 0.5}, .legend = "points"},
      BarLayer{.x = {2.0, 3.0}, .y = {5.0, kNan}, .legend = "bars"},
      MarkerLayer{.x = 7.0, .label = "mark"},
  }));
  ASSERT_EQ(picture.layers.size(), 5);
  EXPECT_EQ(std::get<BandLayer>(picture.layers[0]).upper[0], 2.0);
  EXPECT_EQ(std::get<LoopLayer>(picture.layers[1]).legend, "loop");
  EXPECT_EQ(std::get<PointLayer>(picture.layers[2]).y_error, (std::vector{0.5}));
  EXPECT_EQ(std::get<BarLayer>(picture.layers[3]).x, (std::vector{2.0}));
  EXPECT_EQ(std::get<MarkerLayer>(picture.layers[4]).x, 7.0);
  EXPECT_NO_THROW(check_figure(picture));
}

TEST(StaticPicture, OfManyMarksSomeAreDrawnAndTheLegendSaysSo) {
  std::vector<double> x;
  for (int i = 0; i < 900; ++i) x.push_back(i + 1.0);
  const Figure picture = static_picture(figure_with(
      {PointLayer{.x = x, .y = x, .y_error = x, .legend = "measured"}, LineLayer{x, x, "model"}}));
  ASSERT_EQ(picture.layers.size(), 2);
  const auto& marks = std::get<PointLayer>(picture.layers[0]);
  ASSERT_EQ(marks.x.size(), 100);
  EXPECT_EQ(marks.x[99], 892.0);
  EXPECT_EQ(marks.y, marks.x);
  EXPECT_EQ(marks.y_error, marks.x);
  EXPECT_EQ(marks.legend, "measured, one of 9 points");
  EXPECT_EQ(std::get<LineLayer>(picture.layers[1]).x.size(), 900);
}

TEST(PictureText, SaysWhatIsShown) {
  EXPECT_EQ(picture_text(figure_with({
                LineLayer{{1.0, 2.0, 3.0}, {0.25, kNan, 4.0}, "measured"},
                LineLayer{.x = {1.0}, .y = {1.0}, .legend = "hidden", .shown = false},
                MarkerLayer{.x = 7.0, .label = "limit"},
            })),
            "Loss: D [mJ] over amplitude A [µm]. measured from 0.25 to 4 mJ. limit at 7 µm.");
}

}  // namespace
}  // namespace microslip::static_picture_test
