// SPDX-License-Identifier: MIT
#include "validation/bounds.hpp"

#include <map>
#include <utility>

#include "validation/figure_list.hpp"

namespace microslip::validation {
namespace {

using BoundsOfFigures = std::map<std::pair<std::string, std::string>, Bounds>;

std::optional<double> unscaled(const std::optional<double>& bound, double scale) {
  if (!bound) return std::nullopt;
  return *bound / scale;
}

BoundsOfFigures read_bounds() {
  BoundsOfFigures figures;
  for (const FigureTopic& topic : read_figure_list(MICROSLIP_FIGURES)) {
    for (const FigureLine& line : topic.lines) {
      figures[{line.by, line.figure}] = {.at_least = unscaled(line.at_least, line.scale),
                                         .at_most = unscaled(line.at_most, line.scale)};
    }
  }
  return figures;
}

}  // namespace

Bounds bounds_of(const std::string& test, const std::string& figure) {
  static const BoundsOfFigures figures = read_bounds();
  const auto found = figures.find({test, figure});
  return found == figures.end() ? Bounds{} : found->second;
}

}  // namespace microslip::validation
