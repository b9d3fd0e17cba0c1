// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/gnuplot.hpp"

/// @file
/// Figures as journals print them.

namespace microslip {

/// The page that a figure is for.
struct PaperPrint {
  /// 50 to 400 mm; without one 90, a column, or 190, a page, where panels stand side by side.
  std::optional<double> width_mm = {};
  bool grey = false;  ///< shades of grey in place of colours
};

/// A figure that is drawn.
struct PaperPicture {
  std::string bytes;       ///< of the file
  double width_mm = 0.0;   ///< on paper
  double height_mm = 0.0;  ///< on paper
};

/// Draws with letters of 8 to 10 points whatever the width, axes on all four sides, panels lettered
/// (a), (b), …, and lines of a legend distinguished by their dashes too, unless one is far wider;
/// of more than five some are alike. The height follows from the panels, at most that of a page
/// where their axes can be so low; fewer of them stand side by side where they would be narrower
/// than 55 mm. A PNG has 600 dots per inch.
/// @throws InputError  as draw(), and for a width out of range. @throws Error  as draw().
[[nodiscard]] PaperPicture draw_for_paper(FigureGrid grid, PictureFormat format,
                                          const PaperPrint& print = {});

}  // namespace microslip
