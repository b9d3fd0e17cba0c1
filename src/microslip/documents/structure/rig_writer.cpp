// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "microslip/documents/structure/rig_writer.hpp"
#include "microslip/io/config/toml_lines.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

void write_structure(const Rig& rig, TomlLines& lines) {
  if (const RigBeam* beam = rig.beam()) {
    lines.table("beam");
    lines.add("length_m", beam->length);
    lines.add("width_m", beam->width);
    lines.add("thickness_m", beam->thickness);
    lines.add("youngs_modulus_Pa", beam->youngs_modulus);
    lines.add("mass_density_kg_per_m3", beam->mass_density);
    return;
  }
  lines.table("modes");
  lines.add("frequency_Hz", rig.modes()->frequency);
  lines.add("excitation", rig.modes()->excitation);
  lines.add("joint", rig.modes()->joint);
}

void write_contact(const Rig& rig, TomlLines& lines) {
  const RigContact& contact = rig.contact;
  lines.table("contact");
  if (rig.beam()) lines.add("rod_radius_m", contact.rod_radius);
  if (contact.stiffness) lines.add("stiffness_N_per_m", *contact.stiffness);
  if (contact.stick_frequency) lines.add("stick_frequency_Hz", *contact.stick_frequency);
  if (!contact.joint.empty()) lines.add("joint", contact.joint);
  lines.table("damping");
  lines.add("loss_factor", rig.loss_factor);
  for (const RigMass& mass : rig.masses) {
    lines.element("mass");
    lines.add("position_m", mass.position);
    lines.add("mass_kg", mass.mass);
  }
}

void write_sensors(const Rig& rig, TomlLines& lines) {
  lines.table("excitation");
  if (rig.beam()) lines.add("position_m", rig.excitation.position);
  lines.add("channel", rig.excitation.channel);
  for (const RigSensor& sensor : rig.accelerometers) {
    lines.element("accelerometer");
    if (rig.beam()) {
      lines.add("position_m", sensor.position);
    } else {
      lines.add("shape", sensor.shape);
    }
    lines.add("channel", sensor.channel);
  }
  if (!rig.vibrometer) return;
  lines.table("vibrometer");
  lines.add("channel", rig.vibrometer->channel);
  const bool axial = rig.vibrometer->measures == RigVibrometer::Measures::kAxial;
  lines.add("measures", std::string_view(axial ? "axial" : "joint"));
}

void write_test(const RigTest& test, TomlLines& lines) {
  lines.table("test");
  lines.raw(fmt::format(
      "response_acceleration = {{ from_m_per_s2 = {}, to_m_per_s2 = {}, count = {}, "
      "spacing = \"{}\" }}\n",
      test.response_from, test.response_to, test.count, test.logarithmic ? "log" : "linear"));
  lines.add("sampling_rate_Hz", test.sampling_rate);
  lines.add("duration_s", test.duration);
  lines.add("frequency_resolution_Hz", test.frequency_resolution);
  lines.add("modes", test.modes);
  lines.add("harmonics", test.harmonics);
}

void write_noise(const RigNoise& noise, TomlLines& lines) {
  lines.table("noise");
  lines.add("force_N", noise.force);
  lines.add("acceleration_m_per_s2", noise.acceleration);
  lines.add("vibrometer_m", noise.vibrometer);
}

void write_shaker(const RigShaker& shaker, TomlLines& lines) {
  lines.table("shaker");
  lines.add("resistance_Ohm", shaker.resistance);
  lines.add("inductance_H", shaker.inductance);
  lines.add("force_factor_N_per_A", shaker.force_factor);
  lines.add("moving_mass_kg", shaker.moving_mass);
  lines.add("suspension_stiffness_N_per_m", shaker.suspension_stiffness);
  lines.add("suspension_damping_Ns_per_m", shaker.suspension_damping);
  lines.add("stinger_stiffness_N_per_m", shaker.stinger_stiffness);
}

}  // namespace

std::string format_rig(const Rig& rig) {
  check_rig(rig);
  TomlLines lines;
  lines.add("schema", kRigKind);
  write_structure(rig, lines);
  write_contact(rig, lines);
  write_sensors(rig, lines);
  if (rig.test) write_test(*rig.test, lines);
  if (rig.noise) write_noise(*rig.noise, lines);
  if (rig.shaker) write_shaker(*rig.shaker, lines);
  return std::move(lines).str();
}

}  // namespace microslip
