// SPDX-License-Identifier: MIT
#include "microslip/report/page/html_report_options.hpp"

#include "microslip/report/drawing/gnuplot.hpp"

namespace microslip {

std::function<std::string(const Figure&, int, int)> HtmlReportOptions::default_picture() {
  return [](const Figure& figure, int width, int height) {
    return draw(figure, PictureFormat::kSvg, {width, height});
  };
}

}  // namespace microslip
