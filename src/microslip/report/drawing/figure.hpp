// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/report/drawing/figure_content.hpp"

/// @file
/// Figures, and the rules that they keep before they are drawn.

namespace microslip {

/// Checks what the comments of figure_content.hpp demand, that all numbers are finite and at most
/// 1e100 in magnitude, that a layer other than a marker is shown, and that a value is left to draw
/// on each logarithmic axis.
/// @throws InputError  naming the layer, counted from 0, and the value.
void check_figure(const Figure& figure);

/// Checks each panel, and that there is one.
/// @throws InputError  as above, naming the panel, counted from 0.
void check_figure(const FigureGrid& grid);

/// Checks layers alone.
/// @param prefix  before "layers" in messages.
/// @param layers  each by itself.
/// @param gaps    whether y of lines, loops, points and bars may be no finite number.
/// @throws InputError  as above.
void check_layers(const std::string& prefix, const std::vector<Layer>& layers, bool gaps);

}  // namespace microslip
