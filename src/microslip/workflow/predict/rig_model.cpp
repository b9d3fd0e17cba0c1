// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/rig_model.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_writer.hpp"
#include "microslip/dynamics/structure/damping_twice.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/relative_path.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/rig/setup/rig_structure.hpp"
#include "microslip/workflow/text/named_rig.hpp"

namespace microslip {
namespace {

/// A model is text: names in it are UTF-8 without control characters.
void check_name(std::string_view what, std::string_view name) {
  if (printable(name) == name) return;
  throw InputError(what, in_quotes(name), "must be printable UTF-8 to be named in a model",
                   "Rename it.");
}

/// Points of a model are columns of tables, which not every channel's name can be.
void check_readable(const std::string& text, const std::string& rig, const std::string& out) {
  try {
    (void)parse_model(text, out);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: channel", input_name(rig)));
  }
}

/// rig_modes() has points of the names of the channels.
std::vector<PointSensor> sensors_of(const Rig& rig) {
  std::vector<PointSensor> sensors;
  for (const RigSensor& one : rig.accelerometers) sensors.push_back({one.channel, one.channel});
  return sensors;
}

}  // namespace

RigModel model_of_rig(const NamedInput& input, const JointFile& joint,
                      const std::string& joint_path, std::size_t modes) {
  const Rig rig = parse_rig(input);
  const std::optional<double> damping = identified_damping(joint);
  const StickState state = of_rig(input, [&] { return stick_state(rig, modes); });
  JointedStructure structure = of_rig(
      input, [&] { return rig_structure(rig, state, joint.joint, {1.0}, damping.value_or(0.0)); });
  RigModel model{
      {std::move(structure), rig.excitation.channel, {joint_path}, {covered_to(joint)}, {damping}},
      {},
      {}};
  model.file.accelerometers = sensors_of(rig);
  model.warnings = damping_twice(model.file.structure);
  if (const auto warning = stiffness_warning(state, joint.joint)) {
    model.warnings.push_back(*warning);
  }
  return model;
}

RigModel model_of_rig(const std::string& rig_path, const std::string& joint_path,
                      const std::string& out, std::size_t modes, std::string_view command) {
  if (joint_path == "-") {
    throw InputError("joint", "standard input", "must be a file, which the model names");
  }
  const std::vector<NamedInput> inputs{{rig_path, read_text(rig_path)},
                                       {joint_path, read_text(joint_path)}};
  (void)parse_rig(inputs[0]);  // faults of the first file are reported first
  const JointFile file = parse_joint(inputs[1].text, joint_path);
  check_name("joint", joint_path);
  RigModel model = model_of_rig(inputs[0], file, path_from(joint_path, out), modes);
  model.text =
      format_model(model.file, with_warnings(provenance_of(command, inputs), model.warnings));
  check_readable(model.text, rig_path, out);
  return model;
}

}  // namespace microslip
