// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/paper_picture.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "report/support.hpp"

namespace microslip::paper_picture_test {
namespace {

using test::contains;
using test::density_figure;
using test::input_fault;

FigureGrid grid_of(std::size_t panels, std::size_t columns) {
  return {"", columns, std::vector<Figure>(panels, density_figure())};
}

FigureGrid plain(std::size_t panels, std::size_t columns) {
  FigureGrid grid = grid_of(panels, columns);
  for (Figure& panel : grid.panels) panel.title = panel.subtitle = "";
  return grid;
}

TEST(PaperPicture, IsAColumnOrAPageWide) {
  EXPECT_EQ(draw_for_paper(plain(1, 1), PictureFormat::kSvg).width_mm, 90.0);
  EXPECT_EQ(draw_for_paper(plain(2, 1), PictureFormat::kSvg).width_mm, 90.0);
  EXPECT_EQ(draw_for_paper(plain(2, 2), PictureFormat::kSvg).width_mm, 190.0);
  EXPECT_EQ(draw_for_paper(plain(2, 2), PictureFormat::kSvg, {.width_mm = 120.0}).width_mm, 120.0);
}

TEST(PaperPicture, AnSvgHasItsSizeInMillimetres) {
  const PaperPicture picture = draw_for_paper(plain(1, 1), PictureFormat::kSvg);
  EXPECT_TRUE(contains(picture.bytes, "width=\"90.0")) << picture.bytes.substr(0, 300);
  EXPECT_TRUE(contains(picture.bytes, "mm\" height=\""));
  EXPECT_GT(picture.height_mm, 60.0);
  EXPECT_LT(picture.height_mm, 100.0);
}

// 90 mm are 255 points.
TEST(PaperPicture, APdfHasItsSizeInPoints) {
  const PaperPicture picture = draw_for_paper(plain(1, 1), PictureFormat::kPdf);
  EXPECT_TRUE(contains(picture.bytes, "/MediaBox [ 0 0 255")) << picture.height_mm;
}

// 90 mm are 3.543 inches; the nominal size is in whole px.
TEST(PaperPicture, APngHas600DotsAnInch) {
  const std::string bytes = draw_for_paper(plain(1, 1), PictureFormat::kPng).bytes;
  ASSERT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1A\n");
  const double width =
      256.0 * static_cast<unsigned char>(bytes[18]) + static_cast<unsigned char>(bytes[19]);
  EXPECT_NEAR(width, 90.0 / 25.4 * 600.0, 600.0 / 117.0);
}

TEST(PaperPicture, LettersPanelsWhereThereAreSeveral) {
  EXPECT_FALSE(contains(draw_for_paper(plain(1, 1), PictureFormat::kSvg).bytes, "(a)"));
  const std::string two = draw_for_paper(plain(2, 2), PictureFormat::kSvg).bytes;
  EXPECT_TRUE(contains(two, "<text>(a)</text>"));
  EXPECT_TRUE(contains(two, "<text>(b)</text>"));
  const std::string titled = draw_for_paper(grid_of(2, 1), PictureFormat::kSvg).bytes;
  EXPECT_TRUE(contains(titled, "<text>(b) Distribution density φ(f*)</text>"));
}

TEST(PaperPicture, StacksPanelsThatWouldBeNarrow) {
  const double side_by_side = draw_for_paper(plain(3, 3), PictureFormat::kSvg).height_mm;
  const double stacked =
      draw_for_paper(plain(3, 3), PictureFormat::kSvg, {.width_mm = 90.0}).height_mm;
  EXPECT_GT(stacked, 2.0 * side_by_side);
}

TEST(PaperPicture, HasANameForThoseWhoDoNotSeeIt) {
  EXPECT_TRUE(contains(draw_for_paper(plain(1, 1), PictureFormat::kSvg).bytes,
                       "<title>density φ [1/N] over slip force f* [N]</title>"));
}

TEST(PaperPicture, FitsAPage) {
  EXPECT_LE(draw_for_paper(plain(4, 1), PictureFormat::kSvg, {.width_mm = 190.0}).height_mm, 245.0);
  EXPECT_LE(draw_for_paper(plain(6, 2), PictureFormat::kSvg).height_mm, 245.0);
}

TEST(PaperPicture, GivesLinesOfOneColourlessLookOtherDashes) {
  FigureGrid grid{"", 1, {Figure{}}};
  for (int i = 0; i < 6; ++i) {
    grid.panels[0].layers.emplace_back(
        LineLayer{{0.0, 1.0}, {0.0, 1.0 + i}, std::string(1, static_cast<char>('a' + i))});
  }
  const std::string svg = draw_for_paper(grid, PictureFormat::kSvg).bytes;
  // Four kinds of dashes, each in the plot and in the legend; the sixth line is solid again.
  std::set<std::string> kinds;
  const std::string attribute = "stroke-dasharray=";
  for (std::size_t at = svg.find(attribute); at != std::string::npos;
       at = svg.find(attribute, at + 1)) {
    kinds.insert(svg.substr(at, svg.find_first_of("\"'", at + attribute.size() + 1) - at));
  }
  EXPECT_EQ(kinds.size(), 4U);
}

// The second of each joint shares the entry of the first, and its dashes.
TEST(PaperPicture, LinesOfOneJointLookAlike) {
  FigureGrid grid{"", 1, {Figure{}}};
  for (const std::string name : {"a", "a", "b", "b"}) {
    const int colour = grid.panels[0].layers.size() < 2 ? kBlack : kBlue;
    grid.panels[0].layers.emplace_back(
        LineLayer{{0.0, 1.0}, {0.0, 1.0}, name, {.colour = colour, .style = LineStyle::kDotted}});
  }
  const std::string svg = draw_for_paper(grid, PictureFormat::kSvg).bytes;
  // Two lines and the entry of the legend are dotted; of the other joint, in another colour, none
  // is.
  std::size_t dotted = 0;
  const std::string attribute = "stroke-dasharray=";
  for (std::size_t at = svg.find(attribute); at != std::string::npos;
       at = svg.find(attribute, at + 1)) {
    ++dotted;
  }
  EXPECT_EQ(dotted, 3U);
}

TEST(PaperPicture, InGreyHasNoColours) {
  const auto is_grey = [](const std::string& svg) {
    for (std::size_t at = svg.find("rgb("); at != std::string::npos;
         at = svg.find("rgb(", at + 1)) {
      int red = 0;
      int green = 0;
      int blue = 0;
      std::sscanf(svg.c_str() + at, "rgb(%d,%d,%d)", &red, &green, &blue);
      if (red != green || green != blue) return false;
    }
    return true;
  };
  EXPECT_FALSE(is_grey(draw_for_paper(plain(1, 1), PictureFormat::kSvg).bytes));
  EXPECT_TRUE(is_grey(draw_for_paper(plain(1, 1), PictureFormat::kSvg, {.grey = true}).bytes));
}

TEST(PaperPicture, RefusesAWidthThatIsNone) {
  for (const double width : {49.0, 401.0, -1.0}) {
    EXPECT_TRUE(contains(input_fault([&] {
                           return draw_for_paper(plain(1, 1), PictureFormat::kSvg,
                                                 {.width_mm = width});
                         }),
                         "must be 50 to 400 mm"));
  }
}

}  // namespace
}  // namespace microslip::paper_picture_test
