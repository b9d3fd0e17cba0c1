// SPDX-License-Identifier: MIT
#include "microslip/report/html_report_options.hpp"

#include "microslip/report/gnuplot.hpp"

namespace microslip {

std::function<std::string(const Figure&, int, int)> HtmlReportOptions::default_picture() {
  return [](const Figure& figure, int width, int height) {
    return draw(figure, PictureFormat::kSvg, {width, height});
  };
}

}  // namespace microslip
