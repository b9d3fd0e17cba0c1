// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "microslip/report/drawing/figure_content.hpp"

namespace microslip {

/// How html_report() draws.
struct HtmlReportOptions {
  /// Draws the SVG pictures for paper and for browsers without scripts. By default draw() by
  /// gnuplot; empty for a file without such pictures: the browser then makes those that are
  /// printed.
  std::function<std::string(const Figure&, int width, int height)> picture = default_picture();

  /// What draws them by gnuplot.
  [[nodiscard]] static std::function<std::string(const Figure&, int, int)> default_picture();
};

}  // namespace microslip
