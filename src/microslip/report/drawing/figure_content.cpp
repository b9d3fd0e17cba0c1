// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/figure_content.hpp"

#include <fmt/format.h>

namespace microslip {

std::string axis_text(const FigureAxis& axis) {
  return axis.unit.empty() ? axis.label : fmt::format("{} [{}]", axis.label, axis.unit);
}

const std::string& legend_of(const Layer& layer) {
  return std::visit(
      [](const auto& concrete) -> const std::string& {
        if constexpr (requires { concrete.legend; }) {
          return concrete.legend;
        } else {
          return concrete.label;
        }
      },
      layer);
}

const std::string& name_of(const Layer& layer) {
  return std::visit(
      [&](const auto& concrete) -> const std::string& {
        if constexpr (requires { concrete.name; }) {
          if (!concrete.name.empty()) return concrete.name;
        }
        return legend_of(layer);
      },
      layer);
}

bool is_shown(const Layer& layer) {
  return std::visit(
      [](const auto& concrete) {
        if constexpr (requires { concrete.shown; }) return concrete.shown;
        return true;
      },
      layer);
}

}  // namespace microslip
