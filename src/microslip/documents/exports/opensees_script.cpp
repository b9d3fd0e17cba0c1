// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// How a script calls `uniaxialMaterial`.
struct Script {
  std::string_view elastic_plastic;  ///< tag, stiffness, strain at yield
  std::string_view elastic;          ///< tag, stiffness
  std::string_view parallel_begin;   ///< tag
  std::string_view tag;              ///< of a material in the list
  std::string_view parallel_end;
};

constexpr Script kTcl{"uniaxialMaterial ElasticPP {} {:.16e} {:.16e}\n",
                      "uniaxialMaterial Elastic {} {:.16e}\n", "uniaxialMaterial Parallel {}",
                      " {}", "\n"};
constexpr Script kPython{"    ops.uniaxialMaterial('ElasticPP', {}, {:.16e}, {:.16e})\n",
                         "    ops.uniaxialMaterial('Elastic', {}, {:.16e})\n",
                         "    ops.uniaxialMaterial('Parallel', {}", ", {}", ")\n"};

/// A material each, and all of them in parallel under the first number.
std::string materials(const ExportedJoint& joint, const Script& script) {
  std::string text;
  std::size_t tag = joint.first_number;
  for (const ExportedSlider& slider : joint.sliders) {
    text += fmt::format(fmt::runtime(script.elastic_plastic), ++tag, slider.stiffness,
                        slider.slip_displacement);
  }
  if (joint.spring > 0.0) text += fmt::format(fmt::runtime(script.elastic), ++tag, joint.spring);
  text += fmt::format(fmt::runtime(script.parallel_begin), joint.first_number);
  for (std::size_t i = joint.first_number + 1; i <= tag; ++i) {
    text += fmt::format(fmt::runtime(script.tag), i);
  }
  return text + std::string(script.parallel_end);
}

/// What a reader has to do.
std::string use_of(const ExportedJoint& joint) {
  return fmt::format(
      "# The material {} is the joint: its strain is the displacement of a zeroLength element.\n",
      joint.first_number);
}

}  // namespace

std::string opensees_tcl(const ExportedJoint& joint) {
  return comment_lines(joint, "# ", "opensees") + use_of(joint) + materials(joint, kTcl);
}

std::string opensees_python(const ExportedJoint& joint) {
  return comment_lines(joint, "# ", "openseespy") + use_of(joint) +
         fmt::format("def {}(ops):\n", joint.name) + materials(joint, kPython);
}

}  // namespace microslip
