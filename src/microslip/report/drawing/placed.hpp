// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/report/drawing/text_layout.hpp"

/// @file
/// Things that have got their place in a picture. Lengths in px from its lower left corner, y
/// upwards. Internal to report.

namespace microslip {

struct Box {
  double left = 0.0;
  double bottom = 0.0;
  double right = 0.0;
  double top = 0.0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return top - bottom; }
};

/// Between the edges of a space and the axes in it.
struct Margins {
  double left = 0.0;
  double bottom = 0.0;
  double right = 0.0;
  double top = 0.0;
};

enum class Side { kLeft, kCentre, kRight };

/// One line of text. `side` of it is at x, its middle at y.
struct PlacedText {
  std::string text;
  double x = 0.0;
  double y = 0.0;
  Side side = Side::kLeft;
};

/// The one typeface and its sizes.
inline constexpr const char* kFontName = "DejaVu Sans";
inline constexpr Font kGridTitleFont{.size = 18.0, .bold = true};
inline constexpr Font kTitleFont{.size = 16.0, .bold = true};
inline constexpr Font kLabelFont{.size = 14.0};  ///< of the axes
inline constexpr Font kSmallFont{.size = 13.0};  ///< of all the rest

[[nodiscard]] constexpr double line_height(Font font) { return 1.35 * font.size; }

}  // namespace microslip
