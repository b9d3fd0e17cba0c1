// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/report/drawing/figure.hpp"

/// @file
/// Figures as pictures, drawn by the program gnuplot (5.4).

namespace microslip {

/// Formats of a picture.
enum class PictureFormat {
  kSvg,  ///< for the web; letters stay letters
  kPng,  ///< at twice the nominal size unless the style says otherwise, for sharp screens
  kPdf,  ///< for papers
};

/// The nominal size, px; letters are 11 to 13 px high.
struct PictureSize {
  int width = 800;   ///< 100 to 10000
  int height = 500;  ///< 100 to 10000
};

/// Style of a picture, on screen and in print.
struct PictureStyle {
  double pixels_per_inch = 96.0;  ///< of the nominal size on paper, in SVG and PDF; 24 to 600
  double png_scale = 2.0;         ///< pixels of a PNG file per px of the nominal size; 0.5 to 20
  bool framed = false;            ///< axes on all four sides, no grid lines, as journals have it
  bool grey = false;              ///< shades of grey in place of colours
};

/// The gnuplot commands, with all data in them, that write the picture to standard output. The same
/// figure gives the same script, whatever the locale; no text in the figure can become a command.
/// @throws InputError  where check_figure() does, or the size or the style is out of range.
[[nodiscard]] std::string gnuplot_script(const Figure& figure, PictureFormat format,
                                         PictureSize size = {}, const PictureStyle& style = {});
/// The commands for a grid; the size is that of all panels together.
[[nodiscard]] std::string gnuplot_script(const FigureGrid& grid, PictureFormat format,
                                         PictureSize size, const PictureStyle& style = {});

/// The picture as the bytes of a file, the same at each call. Runs gnuplot as a child; several
/// threads may do this at once.
/// @throws InputError  as gnuplot_script(). @throws Error  where gnuplot is not installed or fails.
[[nodiscard]] std::string draw(const Figure& figure, PictureFormat format, PictureSize size = {},
                               const PictureStyle& style = {});
/// Draws a grid.
[[nodiscard]] std::string draw(const FigureGrid& grid, PictureFormat format, PictureSize size,
                               const PictureStyle& style = {});

/// Runs a script of gnuplot commands. @return its standard output.
/// @throws Error  where gnuplot is not installed, or an error occurs in the script.
[[nodiscard]] std::string run_gnuplot(std::string_view script);

}  // namespace microslip
