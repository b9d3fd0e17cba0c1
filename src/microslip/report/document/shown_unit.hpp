// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/report/document/report_document.hpp"

/// @file
/// Units in which values read well on an axis. Internal to report.

namespace microslip {

/// A unit as it is written on an axis, "µm", and its size in SI.
struct ShownUnit {
  std::string text;
  double size = 1.0;
};

/// The SI unit with the decimal prefix from n to G that brings the largest of the values to 1 or
/// more, below 1000; without one where it is 0.1 to 10000 already. For "m", "N", "J", "s", "N/m"
/// and "m/N". "m/s^2" gets a raised 2; "%" are of 1, "°" of rad; others stay, so that a density is
/// in 1/N as in files and texts.
[[nodiscard]] ShownUnit shown_unit(std::string_view si_unit, double largest);

/// Name of the quantity with the SI unit: "force" of "N"; "signal" of others.
[[nodiscard]] std::string quantity_of_unit(std::string_view si_unit);

/// Turns the x of all layers, with their bars and the range of the axis, from SI to the unit that
/// suits the largest of them, and labels the axis; show_y() does so for y.
void show_x(Figure& figure, std::string_view label, std::string_view si_unit);
void show_y(Figure& figure, std::string_view label, std::string_view si_unit);

/// As above, in a given unit.
void show_x(Figure& figure, std::string_view label, const ShownUnit& unit);
void show_y(Figure& figure, std::string_view label, const ShownUnit& unit);

/// As above, for all choices of a figure of a page, in one unit.
void show_x(ReportFigure& figure, std::string_view label, std::string_view si_unit);
void show_y(ReportFigure& figure, std::string_view label, std::string_view si_unit);

}  // namespace microslip
