// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {

std::string ansys_commands(const ExportedJoint& joint) {
  std::string text = comment_lines(joint, "! ", "ansys");
  text += fmt::format(
      "! Use it by the name of this file without .mac: FILE,NODE_A,NODE_B,DIRECTION with "
      "DIRECTION\n"
      "! 1, 2 or 3 for UX, UY or UZ. Real constants of COMBIN40: K1, C, M, GAP, FSLIDE, K2; the\n"
      "! force is positive where NODE_B moves ahead of NODE_A.\n"
      "*GET,{0}_T,ETYP,0,NUM,MAX\nET,{0}_T+1,COMBIN40,,,ARG3\nTYPE,{0}_T+1\n",
      joint.name);
  std::size_t set = joint.first_number;
  const auto add = [&](double k1, double slide, double k2) {
    text += fmt::format("R,{0},{1:.13e},0,0,0,{2:.13e},{3:.13e}\nREAL,{0}\nE,ARG1,ARG2\n", set, k1,
                        slide, k2);
    ++set;
  };
  for (const ExportedSlider& slider : joint.sliders) add(slider.stiffness, slider.slip_force, 0.0);
  if (joint.spring > 0.0) add(0.0, 0.0, joint.spring);
  return text;
}

}  // namespace microslip
