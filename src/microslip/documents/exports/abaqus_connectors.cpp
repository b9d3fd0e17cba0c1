// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {

std::string abaqus_connectors(const ExportedJoint& joint) {
  const std::size_t a = joint.first_number;
  std::string text = comment_lines(joint, "** ", "abaqus");
  text += fmt::format(
      "** Connectors from node {0} to node {1} (sets {2}_A, {2}_B), component 1 along x of the "
      "axes "
      "{2}_AXES.\n** Give the axes your direction, and tie your nodes to these two.\n"
      "*NODE, NSET={2}_A\n{0}, 0., 0., 0.\n*NODE, NSET={2}_B\n{1}, 0., 0., 0.\n"
      "*ORIENTATION, NAME={2}_AXES\n1., 0., 0., 0., 1., 0.\n",
      a, a + 1, joint.name);
  const std::size_t count = joint.sliders.size() + (joint.spring > 0.0 ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const bool slips = i < joint.sliders.size();
    text += fmt::format(
        "*ELEMENT, TYPE=CONN3D2, ELSET={0}_{1}\n{2}, {3}, {4}\n"
        "*CONNECTOR SECTION, ELSET={0}_{1}, BEHAVIOR={0}_{1}\nCARTESIAN,\n{0}_AXES,\n"
        "*CONNECTOR BEHAVIOR, NAME={0}_{1}\n*CONNECTOR ELASTICITY, COMPONENT=1\n{5:.13e},\n",
        joint.name, i + 1, a + i, a, a + 1, slips ? joint.sliders[i].stiffness : joint.spring);
    if (!slips) continue;
    text += fmt::format(
        "*CONNECTOR PLASTICITY, COMPONENT=1\n"
        "*CONNECTOR HARDENING, TYPE=ISOTROPIC, DEFINITION=TABULAR\n{:.13e}, 0.\n",
        joint.sliders[i].slip_force);
  }
  return text;
}

}  // namespace microslip
