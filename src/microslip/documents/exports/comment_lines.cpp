// SPDX-License-Identifier: MIT
#include "microslip/documents/exports/comment_lines.hpp"

#include <fmt/format.h>

#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/cells/csv_cells.hpp"

namespace microslip {

std::string comment_lines(const ExportedJoint& joint, std::string_view begin,
                          std::string_view target, std::string_view end) {
  std::string text;
  for (std::string_view rest = joint.remarks; !rest.empty();) {
    // A carriage return would end the comment, bytes of no character the reading of the file.
    std::string remark = on_one_line(take_line(rest));
    // What ends a comment of C ends none here.
    for (std::size_t at = remark.find("*/"); at != std::string::npos; at = remark.find("*/")) {
      remark.replace(at, 2, "* /");
    }
    text += fmt::format("{}{}{}\n", begin, remark, end);
  }
  text += fmt::format("{}microslip export: {}{}\n", begin, target, end);
  text += fmt::format("{}{} sliders{}; forces in {}, lengths in {}{}\n", begin,
                      joint.sliders.size(), joint.spring > 0.0 ? " and a spring" : "",
                      joint.units.force, joint.units.length, end);
  return text;
}

}  // namespace microslip
