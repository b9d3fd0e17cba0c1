// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/report/figure.hpp"

/// @file
/// Figures as pictures, drawn by the program gnuplot (5.4).

namespace microslip {

enum class PictureFormat {
  kSvg,  ///< for the web; letters stay letters
  kPng,  ///< at twice the nominal size, for sharp screens
  kPdf,  ///< for papers; 96 px are an inch
};

/// The nominal size, px; letters are 11 to 13 px high.
struct PictureSize {
  int width = 800;   ///< 100 to 10000
  int height = 500;  ///< 100 to 10000
};

/// The gnuplot commands, with all data in them, that write the picture to standard output. The same
/// figure gives the same script, whatever the locale; no text in the figure can become a command.
/// @throws InputError  where check_figure() does, or the size is out of range.
[[nodiscard]] std::string gnuplot_script(const Figure& figure, PictureFormat format,
                                         PictureSize size = {});
[[nodiscard]] std::string gnuplot_script(const FigureGrid& grid, PictureFormat format,
                                         PictureSize size);

/// The picture as the bytes of a file, the same at each call. Runs gnuplot as a child; several
/// threads may do this at once.
/// @throws InputError  as gnuplot_script(). @throws Error  where gnuplot is not installed or fails.
[[nodiscard]] std::string draw(const Figure& figure, PictureFormat format, PictureSize size = {});
[[nodiscard]] std::string draw(const FigureGrid& grid, PictureFormat format, PictureSize size);

/// Runs a script of gnuplot commands. @return what it wrote to standard output.
/// @throws Error  where gnuplot is not installed, or an error occurs in the script.
[[nodiscard]] std::string run_gnuplot(std::string_view script);

}  // namespace microslip
