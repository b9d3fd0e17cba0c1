// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/report/document/report_document.hpp"
#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/gnuplot.hpp"
#include "microslip/workflow/compare/comparison.hpp"

namespace microslip {

/// A row of panels for each test, up to kMostComparedTests, spread over all that there are: each
/// curve over its axis, measured, predicted and the band of the draws, what lies outside in another
/// colour, with the peak where it has one; before them the loop of a record.
/// @param tests  compared. @throws InputError  where no value was predicted.
[[nodiscard]] FigureGrid comparison_figure(std::span<const ComparedTest> tests);

/// Figures for a page: one for each quantity over each axis, in which the reader chooses the
/// test where several have it.
/// @param tests  compared, any number; those without a predicted value are left out.
[[nodiscard]] std::vector<ReportFigure> comparison_figures(std::span<const ComparedTest> tests);

/// The size of its picture.
[[nodiscard]] PictureSize comparison_size(const FigureGrid& figure);

/// More are not drawn together.
inline constexpr std::size_t kMostComparedTests = 8;

}  // namespace microslip
