// SPDX-License-Identifier: MIT
#include "microslip/report/static_picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <variant>
#include <vector>

namespace microslip::static_picture_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ReportFigure figure_with(std::vector<ReportTrace> traces) {
  return {.title = "Loss",
          .x = {.label = "amplitude A", .unit = "µm", .log = true, .range = AxisRange{1.0, 2.0}},
          .y = {.label = "D", .unit = "mJ", .range = AxisRange{0.0, 5.0}},
          .choices = {{"", std::move(traces)}}};
}

TEST(StaticPicture, AxesReadLabelAndUnit) {
  const Figure picture = static_picture(figure_with({{.name = "a", .x = {1.0}, .y = {1.0}}}));
  EXPECT_EQ(picture.x.label, "amplitude A [µm]");
  EXPECT_TRUE(picture.x.log);
  EXPECT_FALSE(picture.x.range.has_value());  // that is of the linear axis
  ASSERT_TRUE(picture.y.range.has_value());
  EXPECT_EQ(picture.y.range->to, 5.0);
}

TEST(StaticPicture, AGapSplitsALineThatStaysOneInTheLegend) {
  const Figure picture = static_picture(
      figure_with({{.name = "a", .x = {1.0, 2.0, 3.0, 4.0}, .y = {1.0, kNan, 3.0, 4.0}}}));
  ASSERT_EQ(picture.layers.size(), 2);
  const auto& first = std::get<LineLayer>(picture.layers[0]);
  const auto& second = std::get<LineLayer>(picture.layers[1]);
  EXPECT_EQ(first.x, (std::vector{1.0}));
  EXPECT_EQ(first.legend, "a");
  EXPECT_EQ(second.y, (std::vector{3.0, 4.0}));
  EXPECT_EQ(second.legend, "");
}

TEST(StaticPicture, EveryKindOfTrace) {
  const Figure picture = static_picture(figure_with({
      {.name = "band", .kind = TraceKind::kBand, .x = {1.0}, .lower = {0.0}, .upper = {2.0}},
      {.name = "loop", .kind = TraceKind::kLoop, .x = {1.0}, .y = {1.0}},
      {.name = "points", .kind = TraceKind::kPoints, .x = {1.0}, .y = {1.0}, .y_std = {0.5}},
      {.name = "mark", .kind = TraceKind::kMarker, .x = {7.0}},
      {.name = "hidden", .x = {1.0}, .y = {1.0}, .shown = false},
  }));
  ASSERT_EQ(picture.layers.size(), 4);
  EXPECT_EQ(std::get<BandLayer>(picture.layers[0]).upper[0], 2.0);
  EXPECT_EQ(std::get<LoopLayer>(picture.layers[1]).legend, "loop");
  EXPECT_EQ(std::get<PointLayer>(picture.layers[2]).y_error[0], 0.5);
  EXPECT_EQ(std::get<MarkerLayer>(picture.layers[3]).x, 7.0);
}

// Two traces share 0.76 of a step of 1; each bar is an area with an edge.
TEST(StaticPicture, BarsOfTracesStandSideBySide) {
  const Figure picture = static_picture(figure_with({
      {.name = "before", .kind = TraceKind::kBars, .x = {2.0, 3.0}, .y = {5.0, kNan}},
      {.name = "after", .kind = TraceKind::kBars, .x = {2.0, 3.0}, .y = {1.0, 0.5}},
  }));
  ASSERT_EQ(picture.layers.size(), 6);
  const auto& before = std::get<BandLayer>(picture.layers[0]);
  EXPECT_EQ(before.x[0], 2.0 - 0.38);
  EXPECT_EQ(before.x[1], 2.0);
  EXPECT_EQ(before.upper, (std::vector{5.0, 5.0}));
  EXPECT_EQ(before.legend, "before");
  const auto& after = std::get<BandLayer>(picture.layers[4]);
  EXPECT_EQ(after.x[0], 3.0);
  EXPECT_EQ(after.upper[0], 0.5);
  EXPECT_EQ(after.legend, "");
}

TEST(StaticPicture, AGroupIsOneInTheLegend) {
  const Figure picture = static_picture(figure_with({
      {.name = "a, predicted", .group = "predicted", .x = {1.0}, .y = {1.0}},
      {.name = "b, predicted", .group = "predicted", .x = {1.0}, .y = {2.0}},
  }));
  ASSERT_EQ(picture.layers.size(), 2);
  EXPECT_EQ(std::get<LineLayer>(picture.layers[0]).legend, "predicted");
  EXPECT_EQ(std::get<LineLayer>(picture.layers[1]).legend, "");
}

TEST(StaticPicture, OfManyMarksSomeAreDrawnAndTheLegendSaysSo) {
  std::vector<double> x;
  for (int i = 0; i < 900; ++i) x.push_back(i + 1.0);
  const Figure picture = static_picture(
      figure_with({{.name = "measured", .kind = TraceKind::kPoints, .x = x, .y = x, .y_std = x},
                   {.name = "model", .x = x, .y = x}}));
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
                {.name = "measured", .x = {1.0, 2.0, 3.0}, .y = {0.25, kNan, 4.0}},
                {.name = "limit", .kind = TraceKind::kMarker, .x = {7.0}},
            })),
            "Loss: D [mJ] over amplitude A [µm]. measured from 0.25 to 4 mJ. limit at 7 µm.");
}

}  // namespace
}  // namespace microslip::static_picture_test
