// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/placed.hpp"

/// @file
/// One figure as gnuplot commands. Internal to report.

namespace microslip {

/// A part of a picture; px.
struct PanelSpace {
  Box box;
  double picture_width = 0.0;
  double picture_height = 0.0;
  std::size_t number = 0;  ///< sets the names of its data blocks apart from those of other panels
  Margins least = {};      ///< that the axes line up with those of other panels
  bool framed = false;     ///< as in PictureStyle
  bool grey = false;
};

/// The text as a string of gnuplot, in double quotes. All that means something to gnuplot in there
/// or might, as quotes, command substitution and macros do, is written as an octal escape. (In
/// single quotes it cannot be: gnuplot 5.4 takes '''a' for an empty string and a second one.)
/// Markup is another matter: `noenhanced` turns it off where the string is used.
[[nodiscard]] std::string gnuplot_string(std::string_view text);

/// The command that writes the text, without markup.
[[nodiscard]] std::string gnuplot_label(const PlacedText& text, Font font, std::string_view colour,
                                        const PanelSpace& space, bool upwards = false);

/// Appends the commands that draw the figure into its space.
void append_panel(std::string& script, const Figure& figure, const PanelSpace& space);

}  // namespace microslip
