// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/report/figure.hpp"
#include "microslip/report/paper_figures.hpp"
#include "plot_input.hpp"

namespace microslip::app {

/// A figure that the program draws.
struct PlotFigure {
  const char* name;                         ///< as on the command line
  const char* shows;                        ///< for the help
  const char* needs;                        ///< files and columns, for messages
  bool (*has)(const PlotInput&);            ///< whether there is the data
  bool (*has_amplitude)(const PlotInput&);  ///< an axis that may be linear or logarithmic
  bool (*takes_others)(const PlotInput&);   ///< draws other joints too
  FigureGrid (*make)(const PlotInput&, const PaperOptions&);
};

/// All of them, in the order of the help.
[[nodiscard]] std::span<const PlotFigure> plot_figures();

/// The one of that name that the input has the data for; of no name, the only one there is.
/// @throws InputError  naming those it has, where there is no name and not one figure alone, the
///                     name is unknown, or the input has no data for it; with what that one needs.
[[nodiscard]] const PlotFigure& find_figure(const std::string& name, const PlotInput& input);

}  // namespace microslip::app
