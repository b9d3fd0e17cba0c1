// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/model_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/config/toml_lines.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

bool is_uncertain(const std::vector<double>& spread) {
  return std::ranges::any_of(spread, [](double value) { return value > 0.0; });
}

double spread_at(const std::vector<double>& spread, std::size_t at) {
  return at < spread.size() ? spread[at] : 0.0;
}

void write_structure(const ModelFile& model, TomlLines& lines) {
  const JointedStructure& structure = model.structure;
  const StructureSpread& spread = model.spread;
  const bool viscous = structure.damping() == DampingLaw::kViscous;
  std::vector<double> frequency;
  std::vector<double> damping;
  for (const Mode& mode : structure.linear().modes()) {
    frequency.push_back(mode.angular_frequency / (2.0 * std::numbers::pi));
    damping.push_back(viscous ? mode.loss_factor / 2.0 : mode.loss_factor);
  }
  lines.table("structure");
  lines.add("frequency_Hz", frequency);
  if (is_uncertain(spread.frequency)) lines.add("frequency_std", spread.frequency);
  lines.add(viscous ? "damping_ratio" : "loss_factor", damping);
  if (is_uncertain(spread.loss_factor)) lines.add("loss_factor_std", spread.loss_factor);
  if (model.static_attachments) lines.add("static_attachments", *model.static_attachments);
  for (const ModalPoint& point : structure.linear().points()) {
    lines.element("structure.point");
    lines.add("name", point.name);
    lines.add("shape", point.shape);
  }
  for (const ModalBase& base : structure.linear().bases()) {
    lines.element("structure.base");
    lines.add("name", base.name);
    lines.add("participation", base.participation);
    lines.add("point_motion", base.point_motion);
  }
}

/// Of an excitation or load: point or base.
void write_place(const JointedStructure& structure, const std::string& place, TomlLines& lines) {
  lines.add(structure.linear().is_base(place) ? "base" : "point", place);
}

/// Without the key a reader takes what the joint file says, and draws bring their own.
bool brings_damping(const ModelFile& model, std::size_t joint) {
  const bool drawn = joint < model.joint_samples.size() && !model.joint_samples[joint].empty() &&
                     joint < model.damping_said.size() && joint < model.identified_damping.size();
  return drawn && model.identified_damping[joint] == model.structure.joints()[joint].linear_damping;
}

bool says_damping(const ModelFile& model, std::size_t joint) {
  const bool given = joint < model.damping_said.size() && model.damping_said[joint];
  if (given) return true;
  if (brings_damping(model, joint)) return false;
  if (model.structure.joints()[joint].linear_damping > 0.0) return true;
  const bool known = joint < model.identified_damping.size();
  return !known || model.identified_damping[joint].value_or(0.0) > 0.0;
}

void write_joint(const ModelFile& model, std::size_t number, TomlLines& lines) {
  const StructuralJoint& joint = model.structure.joints()[number];
  lines.element("joint");
  lines.add("name", joint.name);
  if (model.joint_files[number].empty()) {
    lines.add("stiffness_N_per_m", joint.joint.stiffness());
  } else {
    lines.add("file", model.joint_files[number]);
  }
  const bool drawn = number < model.joint_samples.size() && !model.joint_samples[number].empty();
  if (drawn) lines.add("samples", model.joint_samples[number]);
  const double load = spread_at(model.spread.normal_load, number);
  if (load > 0.0) lines.add("normal_load_std", load);
  lines.add("shape", joint.shape);
  if (joint.spring_in_modes > 0.0) lines.add("spring_in_modes_N_per_m", joint.spring_in_modes);
  if (joint.series_compliance > 0.0) {
    lines.add("series_compliance_m_per_N", joint.series_compliance);
  }
  if (!joint.shortening.empty()) lines.add("shortening_per_kg_m", joint.shortening);
  if (says_damping(model, number)) lines.add(kLinearDampingKey, joint.linear_damping);
}

void write_excitation(const JointedStructure& structure, const Excitation& excitation,
                      const std::string& channel, double gain, TomlLines& lines) {
  std::vector<double> amplitude;
  std::vector<double> phase;
  for (const std::complex<double>& harmonic : excitation.harmonics) {
    amplitude.push_back(std::abs(harmonic));
    phase.push_back(std::arg(harmonic));
  }
  lines.element("excitation");
  write_place(structure, excitation.point, lines);
  if (!channel.empty()) lines.add("channel", channel);
  if (gain > 0.0) lines.add("gain_std", gain);
  if (excitation.harmonics == std::vector<std::complex<double>>{1.0}) return;
  lines.add("harmonics", amplitude);
  lines.add("phase_rad", phase);
}

}  // namespace

std::string format_model(const ModelFile& model, std::string_view comment) {
  const std::span<const StructuralJoint> joints = model.structure.joints();
  if (model.joint_files.size() != joints.size()) {
    throw InputError("joint_files", fmt::format("{} files", model.joint_files.size()),
                     fmt::format("must be {}, one per joint", joints.size()));
  }
  TomlLines lines;
  lines.comment(comment);
  lines.add("schema", kModelKind);
  write_structure(model, lines);
  for (std::size_t i = 0; i < joints.size(); ++i) write_joint(model, i, lines);
  const std::span<const Excitation> excitations = model.structure.excitations();
  for (std::size_t i = 0; i < excitations.size(); ++i) {
    const bool has_channel = i < model.force_channels.size();
    write_excitation(model.structure, excitations[i],
                     has_channel ? model.force_channels[i] : std::string(),
                     spread_at(model.spread.force_gain, i), lines);
  }
  for (const StaticLoad& load : model.structure.static_loads()) {
    lines.element("static_load");
    write_place(model.structure, load.place, lines);
    const bool of_base = model.structure.linear().is_base(load.place);
    lines.add(of_base ? "acceleration_m_per_s2" : "force_N", load.value);
  }
  lines.table("response");
  lines.add("point", model.response);
  if (model.spread.response_gain > 0.0) lines.add("gain_std", model.spread.response_gain);
  for (const PointSensor& sensor : model.accelerometers) {
    lines.element("accelerometer");
    lines.add("channel", sensor.channel);
    lines.add("point", sensor.point);
  }
  return std::move(lines).str();
}

}  // namespace microslip
