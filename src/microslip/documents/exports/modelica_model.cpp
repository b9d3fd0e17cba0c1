// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// A list of Modelica of one number of each slider.
std::string list_of(const ExportedJoint& joint, double ExportedSlider::*number) {
  std::string text = "{";
  for (std::size_t i = 0; i < joint.sliders.size(); ++i) {
    text += fmt::format("{}{:.16e}", i == 0 ? "" : ", ", joint.sliders[i].*number);
    if (i % 4 == 3 && i + 1 < joint.sliders.size()) text += "\n    ";
  }
  return text + "}";
}

}  // namespace

std::string modelica_model(const ExportedJoint& joint) {
  const std::size_t n = joint.sliders.size();
  std::string text = comment_lines(joint, "// ", "modelica");
  text += fmt::format(
      "model {} \"Frictional joint: sliders in parallel between two flanges\"\n"
      "  extends Modelica.Mechanics.Translational.Interfaces.PartialCompliant;\n",
      joint.name);
  if (n > 0) {
    text += fmt::format(
        "  parameter Real stiffness[{0}](each unit = \"N/m\") = {1};\n"
        "  parameter Real slip[{0}](each unit = \"m\") = {2} \"stretch at which a slider "
        "slips\";\n",
        n, list_of(joint, &ExportedSlider::stiffness),
        list_of(joint, &ExportedSlider::slip_displacement));
  }
  text += fmt::format("  parameter Real spring(unit = \"N/m\") = {:.16e};\n", joint.spring);
  if (n > 0) {
    text += fmt::format(
        "  Real position[{0}](each unit = \"m\", each start = 0, each fixed = true)\n"
        "    \"of the sliders\";\n"
        "protected\n"
        "  Real velocity(unit = \"m/s\") = der(s_rel);\n"
        "equation\n"
        "  for i in 1:{0} loop\n"
        "    der(position[i]) = if s_rel - position[i] >= slip[i] and velocity > 0 or\n"
        "      s_rel - position[i] <= -slip[i] and velocity < 0 then velocity else 0;\n"
        "  end for;\n"
        "  f = stiffness*(s_rel*ones({0}) - position) + spring*s_rel;\n",
        n);
  } else {
    text += "equation\n  f = spring*s_rel;\n";
  }
  return text + fmt::format("end {};\n", joint.name);
}

}  // namespace microslip
