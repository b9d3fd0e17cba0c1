// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/report/document/figure_options.hpp"
#include "microslip/report/drawing/gnuplot.hpp"
#include "microslip/report/figures/named_figures.hpp"

namespace microslip::app {

/// The options of `plot` as they are typed.
struct PlotArguments {
  std::vector<std::string> in;
  std::string figure;
  std::string format;
  std::string out;
  std::vector<std::string> others;
  std::optional<double> width_mm;
  std::string time;
  std::optional<std::size_t> record;
  bool grey = false;
  bool log = false;
  bool linear = false;
};

/// All but --quiet.
void add_plot_arguments(CLI::App& command, PlotArguments& options);

/// The figures, for the end of the help.
[[nodiscard]] std::string figures_help();

/// By --format, by the ending of --out, or SVG. @throws InputError  where the two differ.
[[nodiscard]] PictureFormat format_of(const PlotArguments& options);

/// @throws InputError  for what the figure does not take.
[[nodiscard]] FigureOptions figure_options(const PlotArguments& options, const NamedFigure& figure,
                                           const ResultInput& input);

}  // namespace microslip::app
