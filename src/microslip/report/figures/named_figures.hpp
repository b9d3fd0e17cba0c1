// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/report/document/figure_options.hpp"
#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/paper_picture.hpp"
#include "microslip/workflow/results/result_input.hpp"

namespace microslip {

/// A figure that the program draws.
struct NamedFigure {
  const char* name;                           ///< as on the command line
  const char* shows;                          ///< for the help
  const char* needs;                          ///< files and columns, for messages
  bool (*has)(const ResultInput&);            ///< whether there is the data
  bool (*has_amplitude)(const ResultInput&);  ///< an axis that may be linear or logarithmic
  bool (*takes_others)(const ResultInput&);   ///< draws other joints too
  FigureGrid (*make)(const ResultInput&, const FigureOptions&);
  bool of_record = false;  ///< of one record that a joint was identified from, over time
};

/// All of them, in the order of the help.
[[nodiscard]] std::span<const NamedFigure> named_figures();

/// The one of that name that the input has the data for; of no name, the only one there is.
/// @throws InputError  naming those it has, where there is no name and not one figure alone, the
///                     name is unknown, or the input has no data for it; with what that one needs.
[[nodiscard]] const NamedFigure& find_figure(const std::string& name, const ResultInput& input);

/// The figure for paper. @throws InputError  naming the file and, where it can, the axis of a value
/// that cannot be drawn; as draw_for_paper().
[[nodiscard]] PaperPicture draw_named(const NamedFigure& figure, const ResultInput& input,
                                      const FigureOptions& options, PictureFormat format,
                                      const PaperPrint& print);

}  // namespace microslip
