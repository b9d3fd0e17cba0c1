// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/report_document.hpp"

/// @file
/// A figure of a report as a picture for paper and for browsers without scripts. Internal to
/// report.

namespace microslip {

/// The chosen content on the axes as they are at first; traces that are not shown, and what has no
/// place on a logarithmic axis, are left out. Bars are those of whole numbers.
[[nodiscard]] Figure static_picture(const ReportFigure& figure);

/// What the figure shows, for those who do not see it: axes, and each trace with its range.
[[nodiscard]] std::string picture_text(const ReportFigure& figure);

}  // namespace microslip
