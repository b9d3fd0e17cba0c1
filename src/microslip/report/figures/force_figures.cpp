// SPDX-License-Identifier: MIT
#include "microslip/report/figures/force_figures.hpp"

#include <cstddef>
#include <utility>

#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/compared_loops.hpp"
#include "microslip/report/figures/force_layers.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostOnPaper = 20000;  // samples

const ForcePath& record_of(const ExperimentResults& results) {
  if (results.force_paths.empty()) {
    throw_missing("records", "the figure needs recordings that the joint was identified from");
  }
  return results.force_paths.front();
}

Figure panel(std::vector<Layer> layers) {
  Figure figure{.layers = std::move(layers)};
  check_figure(figure);
  return figure;
}

Figure residual_panel(const ExperimentResults& results) {
  const ForcePath& path = record_of(results);
  Figure figure = panel(residual_layers(path, scatter_of(results, path), kMostOnPaper));
  show_x(figure, "time", "s");
  show_y(figure, kResidualLabel, "N");
  return figure;
}

}  // namespace

FigureGrid record_force_figure(const ExperimentResults& results, const FigureOptions& /*options*/) {
  Figure force = panel(force_layers(record_of(results), kMostOnPaper));
  show_x(force, "time", "s");
  show_y(force, kLoopForce, "N");
  return {"", 1, {std::move(force), residual_panel(results)}};
}

Figure record_loops_figure(const ExperimentResults& results, const FigureOptions& /*options*/) {
  Figure figure = panel(loop_layers(record_of(results), kMostOnPaper));
  show_x(figure, kLoopDisplacement, "m");
  show_y(figure, kLoopForce, "N");
  return figure;
}

FigureGrid residuals_figure(const ExperimentResults& results, const FigureOptions& /*options*/) {
  const ForcePath& path = record_of(results);
  Figure over_displacement = panel(residual_over_displacement(path, scatter_of(results, path)));
  show_x(over_displacement, kLoopDisplacement, "m");
  show_y(over_displacement, kResidualLabel, "N");
  return {"", 2, {residual_panel(results), std::move(over_displacement)}};
}

}  // namespace microslip
