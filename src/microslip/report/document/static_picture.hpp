// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/report_document.hpp"

/// @file
/// A figure of a report as a picture for paper and for browsers without scripts. Internal to
/// report.

namespace microslip {

/// The chosen content without headings, which the page has. Gaps split a layer; of many marks some
/// are drawn, and the legend says so.
[[nodiscard]] Figure static_picture(const ReportFigure& figure);

/// Text that describes the figure to those who do not see it: axes, and each layer with its range.
[[nodiscard]] std::string picture_text(const ReportFigure& figure);

}  // namespace microslip
