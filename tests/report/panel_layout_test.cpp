// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/panel_layout.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/support.hpp"

namespace microslip::panel_layout_test {
namespace {

using test::contains;
using test::density_figure;
using test::input_fault;

constexpr Box kSpace{.left = 0.0, .bottom = 0.0, .right = 800.0, .top = 500.0};

/// The box of a line of text, a little less than its line height.
Box box_of(const PlacedText& text, Font font) {
  const double width = text_width(text.text, font);
  const double left = text.side == Side::kLeft     ? text.x
                      : text.side == Side::kCentre ? text.x - 0.5 * width
                                                   : text.x - width;
  const double half = 0.5 * font.size;
  return {.left = left, .bottom = text.y - half, .right = left + width, .top = text.y + half};
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

/// All that may not cover each other: axes, texts, samples of the legend.
std::vector<Box> boxes_of(const PanelLayout& layout, bool legend_outside) {
  std::vector<Box> boxes = {layout.axes};
  for (const PlacedText& text : layout.title) boxes.push_back(box_of(text, kTitleFont));
  for (const PlacedText& text : layout.subtitle) boxes.push_back(box_of(text, kSmallFont));
  for (const PlacedText& text : layout.x_label) boxes.push_back(box_of(text, kLabelFont));
  for (const PlacedMarker& marker : layout.markers) {
    boxes.push_back(box_of(marker.label, kSmallFont));
  }
  for (const PlacedTick& tick : layout.numbers) {
    boxes.push_back(
        box_of({.text = tick.label.text, .x = tick.x, .y = tick.y, .side = tick.side}, kSmallFont));
  }
  for (const PlacedText& text : layout.y_label) {
    const double half = 0.5 * text_width(text.text, kLabelFont);
    boxes.push_back({.left = text.x - 0.5 * kLabelFont.size,
                     .bottom = text.y - half,
                     .right = text.x + 0.5 * kLabelFont.size,
                     .top = text.y + half});
  }
  if (!legend_outside) return boxes;
  for (const LegendEntry& entry : layout.legend) {
    boxes.push_back({.left = entry.x,
                     .bottom = entry.y - 5.0,
                     .right = entry.x + kSampleWidth,
                     .top = entry.y + 5.0});
    for (const PlacedText& text : entry.lines) boxes.push_back(box_of(text, kSmallFont));
  }
  return boxes;
}

void expect_tidy(const Figure& figure) {
  const bool outside = figure.legend == Legend::kBelow || figure.legend == Legend::kRight;
  const std::vector<Box> boxes = boxes_of(panel_layout(figure, kSpace), outside);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].left, kSpace.left) << i;
    EXPECT_GE(boxes[i].bottom, kSpace.bottom) << i;
    EXPECT_LE(boxes[i].right, kSpace.right) << i;
    EXPECT_LE(boxes[i].top, kSpace.top) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << i << " " << j;
  }
}

Figure verbose_figure() {
  Figure figure = density_figure();
  figure.title =
      "A title that is far too long for one line and goes on until there are two of them";
  figure.y.label =
      "a label of the axis that is longer than the axis itself will be in the end [1/N]";
  for (const double x : {0.1, 0.4, 10.0, 10.5, 19.9}) {
    figure.layers.emplace_back(MarkerLayer{.x = x, .label = "a marker among others"});
  }
  for (int i = 0; i < 6; ++i) {
    figure.layers.emplace_back(
        LineLayer{.x = {0.0, 1.0},
                  .y = {0.0, 0.1},
                  .legend = std::string(static_cast<std::size_t>(10 + 30 * i), 'w') + " x"});
  }
  return figure;
}

TEST(PanelLayout, NothingCoversAnything) {
  for (const Legend legend : {Legend::kBelow, Legend::kRight, Legend::kTopLeft, Legend::kNone}) {
    Figure figure = density_figure();
    figure.legend = legend;
    expect_tidy(figure);
    figure.x.log = true;
    figure.y.log = true;
    expect_tidy(figure);
  }
}

TEST(PanelLayout, NorDoesItWithLongTexts) {
  for (const Legend legend : {Legend::kBelow, Legend::kRight}) {
    Figure figure = verbose_figure();
    figure.legend = legend;
    expect_tidy(figure);
  }
}

TEST(PanelLayout, ALegendInsideStaysInItsCorner) {
  Figure figure = density_figure();
  figure.legend = Legend::kBottomRight;
  const PanelLayout layout = panel_layout(figure, kSpace);
  EXPECT_EQ(layout.legend.size(), 3U);
  EXPECT_GT(layout.legend_box.left, layout.axes.left + 0.5 * layout.axes.width());
  EXPECT_LT(layout.legend_box.right, layout.axes.right);
  EXPECT_GT(layout.legend_box.bottom, layout.axes.bottom);
  EXPECT_LT(layout.legend_box.top, layout.axes.bottom + 0.5 * layout.axes.height());
}

TEST(PanelLayout, LayersWithOneLegendShareItsEntry) {
  Figure figure = density_figure();
  figure.layers.emplace_back(LineLayer{.x = {0.0}, .y = {0.0}, .legend = "truth"});
  figure.layers.emplace_back(
      LineLayer{.x = {0.0}, .y = {0.0}, .legend = "of a page alone", .shown = false});
  EXPECT_EQ(panel_layout(figure, kSpace).legend.size(), 3U);
}

TEST(PanelLayout, ALegendThatIsTooLongSaysHowMuchIsLeftOut) {
  Figure figure = density_figure();
  for (int i = 0; i < 200; ++i) {
    figure.layers.emplace_back(
        LineLayer{.x = {0.0}, .y = {0.0}, .legend = "one of many " + std::to_string(i)});
  }
  for (const Legend legend : {Legend::kBelow, Legend::kRight, Legend::kTopLeft}) {
    figure.legend = legend;
    const PanelLayout layout = panel_layout(figure, kSpace);
    const LegendEntry& last = layout.legend.back();
    EXPECT_FALSE(last.layer.has_value());
    EXPECT_EQ(last.lines.at(0).text,
              "… " + std::to_string(203 - (layout.legend.size() - 1)) + " more");
    if (legend != Legend::kTopLeft) expect_tidy(figure);
  }
}

TEST(PanelLayout, MarkersBeyondTheRangeAreLeftOut) {
  Figure figure = density_figure();
  figure.x.range = AxisRange{.from = 0.0, .to = 10.0};
  EXPECT_TRUE(panel_layout(figure, kSpace).markers.empty());
}

TEST(PanelLayoutFault, NoRoomForTheAxes) {
  EXPECT_TRUE(contains(input_fault([] {
                         return panel_layout(density_figure(), {0.0, 0.0, 100.0, 100.0});
                       }),
                       "must leave room for its axes. Make the picture larger"));
}

TEST(PanelLayout, KeepsTheMarginsThatAreAskedFor) {
  const PanelLayout own = panel_layout(density_figure(), kSpace);
  const Margins margins = margins_of(own, kSpace);
  EXPECT_DOUBLE_EQ(margins.left, own.axes.left);
  EXPECT_DOUBLE_EQ(margins.top, kSpace.top - own.axes.top);
  const Margins least{.left = margins.left + 30.0,
                      .bottom = margins.bottom + 20.0,
                      .right = margins.right + 10.0,
                      .top = margins.top + 5.0};
  const PanelLayout moved = panel_layout(density_figure(), kSpace, least);
  EXPECT_DOUBLE_EQ(moved.axes.left, own.axes.left + 30.0);
  EXPECT_DOUBLE_EQ(moved.axes.bottom, own.axes.bottom + 20.0);
  EXPECT_DOUBLE_EQ(moved.axes.right, own.axes.right - 10.0);
  EXPECT_DOUBLE_EQ(moved.axes.top, own.axes.top - 5.0);
  // The parts at an edge move along.
  EXPECT_DOUBLE_EQ(moved.y_label.at(0).x, own.y_label.at(0).x + 30.0);
  EXPECT_DOUBLE_EQ(moved.x_label.at(0).y, own.x_label.at(0).y + 20.0);
  EXPECT_DOUBLE_EQ(moved.legend.at(0).y, own.legend.at(0).y + 20.0);
  EXPECT_DOUBLE_EQ(moved.markers.at(0).label.y, own.markers.at(0).label.y - 5.0);
  const PanelLayout same = panel_layout(density_figure(), kSpace, Margins{});
  EXPECT_EQ(same.axes.left, own.axes.left);
}

TEST(PanelLayout, NumbersOfALowAxisAreAsDenseAsTheyFit) {
  const Figure figure{.y = {.label = "force", .unit = "N"},
                      .layers = {LineLayer{.x = {0.0, 1.0}, .y = {0.0, 100.0}}}};
  const PanelLayout layout =
      panel_layout(figure, {.left = 0.0, .bottom = 0.0, .right = 400.0, .top = 190.0});
  // Of some 130 px; a number takes 30.
  EXPECT_GE(layout.y_ticks.labelled.size(), 3U);
}

}  // namespace
}  // namespace microslip::panel_layout_test
