// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "microslip/report/drawing/figure_content.hpp"

namespace microslip {

/// Options of html_report().
struct HtmlReportOptions {
  /// Draws the SVG pictures for paper and for browsers without scripts. By default draw() by
  /// gnuplot; empty for a file without such pictures: the browser then makes those that are
  /// printed.
  std::function<std::string(const Figure&, int width, int height)> picture = default_picture();

  /// Draws them by gnuplot.
  [[nodiscard]] static std::function<std::string(const Figure&, int, int)> default_picture();
};

}  // namespace microslip
