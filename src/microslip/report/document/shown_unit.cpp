// SPDX-License-Identifier: MIT
#include "microslip/report/document/shown_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace microslip {
namespace {

struct Prefix {
  const char* text;
  double size;
};

constexpr std::array<Prefix, 7> kPrefixes = {
    {{"G", 1e9}, {"M", 1e6}, {"k", 1e3}, {"", 1.0}, {"m", 1e-3}, {"µ", 1e-6}, {"n", 1e-9}}};

/// The prefix that brings the value to 1 or more.
Prefix prefix_of(double largest) {
  if (largest == 0.0 || (largest >= 0.1 && largest < 1e4)) return {"", 1.0};
  for (const Prefix& prefix : kPrefixes) {
    // Rounding of what was computed must not turn 1 mm to 1000 µm.
    if (largest >= prefix.size * (1.0 - 1e-9)) return prefix;
  }
  return kPrefixes.back();
}

bool takes_prefix(std::string_view unit) {
  constexpr std::array<std::string_view, 6> kUnits = {"m", "N", "J", "s", "N/m", "m/N"};
  return std::ranges::find(kUnits, unit) != kUnits.end();
}

/// Calls `change` with each vector of values over one axis.
template <class Change>
void change_x(Layer& layer, const Change& change) {
  std::visit(
      [&](auto& concrete) {
        using L = std::remove_cvref_t<decltype(concrete)>;
        if constexpr (std::is_same_v<L, MarkerLayer>) {
          std::array<double, 1> at = {concrete.x};
          change(std::span<double>(at));
          concrete.x = at[0];
        } else {
          change(std::span<double>(concrete.x));
          if constexpr (std::is_same_v<L, PointLayer>) {
            change(std::span<double>(concrete.x_error));
          }
        }
      },
      layer);
}

template <class Change>
void change_y(Layer& layer, const Change& change) {
  std::visit(
      [&](auto& concrete) {
        using L = std::remove_cvref_t<decltype(concrete)>;
        if constexpr (std::is_same_v<L, BandLayer>) {
          change(std::span<double>(concrete.lower));
          change(std::span<double>(concrete.upper));
        } else if constexpr (!std::is_same_v<L, MarkerLayer>) {
          change(std::span<double>(concrete.y));
          if constexpr (std::is_same_v<L, PointLayer>) {
            change(std::span<double>(concrete.y_error));
          }
        }
      },
      layer);
}

/// All layers over a pair of axes.
std::vector<Layer*> layers_in(Figure& figure) {
  std::vector<Layer*> layers;
  for (Layer& layer : figure.layers) layers.push_back(&layer);
  return layers;
}

std::vector<Layer*> layers_in(ReportFigure& figure) {
  std::vector<Layer*> layers = layers_in(figure.figure);
  for (FigureChoice& choice : figure.choices) {
    for (Layer& layer : choice.layers) layers.push_back(&layer);
  }
  return layers;
}

/// Calls `change` with each vector of values over the axis.
template <class Change>
void change_along(FigureAxis Figure::*axis, const std::vector<Layer*>& layers,
                  const Change& change) {
  for (Layer* layer : layers) {
    if (axis == &Figure::x) {
      change_x(*layer, change);
    } else {
      change_y(*layer, change);
    }
  }
}

double largest_along(FigureAxis Figure::*axis, const std::vector<Layer*>& layers) {
  double largest = 0.0;
  change_along(axis, layers, [&](std::span<double> values) {
    for (const double value : values) {
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
  });
  return largest;
}

void show_along(FigureAxis Figure::*along, Figure& figure, const std::vector<Layer*>& layers,
                std::string_view label, const ShownUnit& unit) {
  change_along(along, layers, [&](std::span<double> values) {
    for (double& value : values) value /= unit.size;
  });
  FigureAxis& axis = figure.*along;
  if (axis.range) axis.range = AxisRange{axis.range->from / unit.size, axis.range->to / unit.size};
  axis.label = label;
  axis.unit = unit.text;
}

void show_as_suits(FigureAxis Figure::*along, Figure& figure, const std::vector<Layer*>& layers,
                   std::string_view label, std::string_view si_unit) {
  show_along(along, figure, layers, label, shown_unit(si_unit, largest_along(along, layers)));
}

}  // namespace

ShownUnit shown_unit(std::string_view si_unit, double largest) {
  if (si_unit == "m/s^2") return {"m/s²", 1.0};
  if (si_unit == "%") return {"%", 0.01};
  if (si_unit == "°") return {"°", std::numbers::pi / 180.0};
  if (!takes_prefix(si_unit)) return {std::string(si_unit), 1.0};
  const Prefix prefix = prefix_of(largest);
  return {prefix.text + std::string(si_unit), prefix.size};
}

std::string quantity_of_unit(std::string_view si_unit) {
  if (si_unit == "N") return "force";
  if (si_unit == "m/s^2") return "acceleration";
  if (si_unit == "m/s") return "velocity";
  if (si_unit == "m") return "displacement";
  return "signal";
}

void show_x(Figure& figure, std::string_view label, std::string_view si_unit) {
  show_as_suits(&Figure::x, figure, layers_in(figure), label, si_unit);
}

void show_y(Figure& figure, std::string_view label, std::string_view si_unit) {
  show_as_suits(&Figure::y, figure, layers_in(figure), label, si_unit);
}

void show_x(Figure& figure, std::string_view label, const ShownUnit& unit) {
  show_along(&Figure::x, figure, layers_in(figure), label, unit);
}

void show_y(Figure& figure, std::string_view label, const ShownUnit& unit) {
  show_along(&Figure::y, figure, layers_in(figure), label, unit);
}

void show_x(ReportFigure& figure, std::string_view label, std::string_view si_unit) {
  show_as_suits(&Figure::x, figure.figure, layers_in(figure), label, si_unit);
}

void show_y(ReportFigure& figure, std::string_view label, std::string_view si_unit) {
  show_as_suits(&Figure::y, figure.figure, layers_in(figure), label, si_unit);
}

}  // namespace microslip
