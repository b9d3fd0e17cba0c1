// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/rig_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/config/toml_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLargestRigFile = std::size_t{1} << 20U;

RigBeam read_beam(const TomlTable& beam) {
  beam.allow_only(
      {"length_m", "width_m", "thickness_m", "youngs_modulus_Pa", "mass_density_kg_per_m3"});
  return {.length = beam.number("length_m"),
          .width = beam.number("width_m"),
          .thickness = beam.number("thickness_m"),
          .youngs_modulus = beam.number("youngs_modulus_Pa"),
          .mass_density = beam.number("mass_density_kg_per_m3")};
}

RigModes read_modes(const TomlTable& modes) {
  modes.allow_only({"frequency_Hz", "excitation", "joint"});
  return {.frequency = modes.numbers("frequency_Hz"),
          .excitation = modes.numbers("excitation"),
          .joint = modes.numbers("joint")};
}

void read_structure(const TomlTable& top, Rig& rig) {
  const bool has_beam = top.has("beam");
  if (has_beam == top.has("modes")) {
    throw FormatError(top.place("beam"), "one of the tables [beam] and [modes]",
                      has_beam ? "both" : "neither");
  }
  if (has_beam) {
    rig.structure = read_beam(top.table("beam"));
  } else {
    rig.structure = read_modes(top.table("modes"));
  }
}

std::optional<double> optional_number(const TomlTable& table, std::string_view key) {
  if (!table.has(key)) return {};
  return table.number(key);
}

std::string read_joint_path(const TomlTable& contact) {
  if (!contact.has("joint")) return {};
  const std::string path = contact.text("joint");
  if (!path.empty()) return path;
  throw InputError(contact.name("joint"), "''", "must be the path of a joint file",
                   "Leave the key out where the joint is not known.");
}

RigContact read_contact(const TomlTable& contact, bool is_beam) {
  std::vector<std::string_view> keys{"stiffness_N_per_m", "stick_frequency_Hz", "joint"};
  if (is_beam) keys.insert(keys.begin(), "rod_radius_m");
  contact.allow_only(keys);
  return {.rod_radius = is_beam ? contact.number("rod_radius_m") : 0.0,
          .stiffness = optional_number(contact, "stiffness_N_per_m"),
          .stick_frequency = optional_number(contact, "stick_frequency_Hz"),
          .joint = read_joint_path(contact)};
}

std::vector<double> read_loss_factor(const TomlTable& damping) {
  damping.allow_only({"loss_factor"});
  return damping.numbers("loss_factor");
}

std::vector<RigMass> read_masses(const TomlTable& top) {
  std::vector<RigMass> masses;
  if (!top.has("mass")) return masses;
  for (const TomlTable& mass : top.tables("mass")) {
    mass.allow_only({"position_m", "mass_kg"});
    masses.push_back({.position = mass.number("position_m"), .mass = mass.number("mass_kg")});
  }
  return masses;
}

RigSensor read_excitation(const TomlTable& excitation, bool is_beam) {
  RigSensor result;
  if (is_beam) {
    excitation.allow_only({"position_m", "channel"});
    result.position = excitation.number("position_m");
  } else {
    excitation.allow_only({"channel"});
  }
  result.channel = excitation.text("channel");
  return result;
}

RigSensor read_accelerometer(const TomlTable& accelerometer, bool is_beam) {
  RigSensor result;
  if (is_beam) {
    accelerometer.allow_only({"position_m", "channel"});
    result.position = accelerometer.number("position_m");
  } else {
    accelerometer.allow_only({"shape", "channel"});
    result.shape = accelerometer.numbers("shape");
  }
  result.channel = accelerometer.text("channel");
  return result;
}

/// The text of a key that has two of them: whether it is the second.
bool is_second(const TomlTable& table, std::string_view key, std::string_view first,
               std::string_view second) {
  const std::string text = table.text(key);
  if (text == first || text == second) return text == second;
  throw InputError(table.name(key), in_quotes(text),
                   fmt::format("must be \"{}\" or \"{}\"", first, second));
}

RigVibrometer read_vibrometer(const TomlTable& vibrometer) {
  using Measures = RigVibrometer::Measures;
  vibrometer.allow_only({"channel", "measures"});
  return {.channel = vibrometer.text("channel"),
          .measures = is_second(vibrometer, "measures", "joint", "axial") ? Measures::kAxial
                                                                          : Measures::kJoint};
}

RigTest read_test(const TomlTable& table) {
  table.allow_only({"response_acceleration", "sampling_rate_Hz", "duration_s",
                    "frequency_resolution_Hz", "modes", "harmonics"});
  const TomlTable response = table.table("response_acceleration");
  response.allow_only({"from_m_per_s2", "to_m_per_s2", "count", "spacing"});
  RigTest test;
  test.response_from = response.number("from_m_per_s2");
  test.response_to = response.number("to_m_per_s2");
  test.count = response.whole("count");
  test.logarithmic = is_second(response, "spacing", "linear", "log");
  test.sampling_rate = table.number("sampling_rate_Hz");
  test.duration = table.number("duration_s");
  test.frequency_resolution =
      optional_number(table, "frequency_resolution_Hz").value_or(test.frequency_resolution);
  if (table.has("modes")) test.modes = table.whole("modes");
  if (table.has("harmonics")) test.harmonics = table.whole("harmonics");
  return test;
}

RigNoise read_noise(const TomlTable& noise) {
  noise.allow_only({"force_N", "acceleration_m_per_s2", "vibrometer_m"});
  return {.force = optional_number(noise, "force_N").value_or(0.0),
          .acceleration = optional_number(noise, "acceleration_m_per_s2").value_or(0.0),
          .vibrometer = optional_number(noise, "vibrometer_m").value_or(0.0)};
}

RigShaker read_shaker(const TomlTable& table) {
  RigShaker shaker;
  const std::pair<std::string_view, double*> keys[] = {
      {"resistance_Ohm", &shaker.resistance},
      {"inductance_H", &shaker.inductance},
      {"force_factor_N_per_A", &shaker.force_factor},
      {"moving_mass_kg", &shaker.moving_mass},
      {"suspension_stiffness_N_per_m", &shaker.suspension_stiffness},
      {"suspension_damping_Ns_per_m", &shaker.suspension_damping},
      {"stinger_stiffness_N_per_m", &shaker.stinger_stiffness}};
  std::vector<std::string_view> names;
  for (const auto& [name, value] : keys) names.push_back(name);
  table.allow_only(names);
  for (const auto& [name, value] : keys) {
    *value = optional_number(table, name).value_or(*value);
  }
  return shaker;
}

Rig read_tables(const TomlTable& top) {
  top.allow_only({"schema", "beam", "modes", "contact", "damping", "mass", "excitation",
                  "accelerometer", "vibrometer", "test", "noise", "shaker"});
  Rig rig;
  read_structure(top, rig);
  const bool is_beam = rig.beam() != nullptr;
  if (is_beam || top.has("contact")) rig.contact = read_contact(top.table("contact"), is_beam);
  rig.loss_factor = read_loss_factor(top.table("damping"));
  rig.masses = read_masses(top);
  rig.excitation = read_excitation(top.table("excitation"), is_beam);
  for (const TomlTable& accelerometer : top.tables("accelerometer")) {
    rig.accelerometers.push_back(read_accelerometer(accelerometer, is_beam));
  }
  if (top.has("vibrometer")) rig.vibrometer = read_vibrometer(top.table("vibrometer"));
  if (top.has("test")) rig.test = read_test(top.table("test"));
  if (top.has("noise")) rig.noise = read_noise(top.table("noise"));
  if (top.has("shaker")) rig.shaker = read_shaker(top.table("shaker"));
  return rig;
}

/// Fields of Rig that have other names in the file, without the [i] of a list.
constexpr std::array<std::pair<std::string_view, std::string_view>, 34> kKeys{{
    {"beam.length", "beam.length_m"},
    {"beam.width", "beam.width_m"},
    {"beam.thickness", "beam.thickness_m"},
    {"beam.youngs_modulus", "beam.youngs_modulus_Pa"},
    {"beam.mass_density", "beam.mass_density_kg_per_m3"},
    {"modes.frequency", "modes.frequency_Hz"},
    {"contact.stiffness", "contact.stiffness_N_per_m"},
    {"contact.stick_frequency", "contact.stick_frequency_Hz"},
    {"contact.rod_radius", "contact.rod_radius_m"},
    {"loss_factor", "damping.loss_factor"},
    {"masses", "mass"},
    {"masses.mass", "mass.mass_kg"},
    {"masses.position", "mass.position_m"},
    {"excitation.position", "excitation.position_m"},
    {"accelerometers", "accelerometer"},
    {"accelerometers.position", "accelerometer.position_m"},
    {"accelerometers.shape", "accelerometer.shape"},
    {"accelerometers.channel", "accelerometer.channel"},
    {"test.response_from", "test.response_acceleration.from_m_per_s2"},
    {"test.response_to", "test.response_acceleration.to_m_per_s2"},
    {"test.count", "test.response_acceleration.count"},
    {"test.sampling_rate", "test.sampling_rate_Hz"},
    {"test.duration", "test.duration_s"},
    {"test.frequency_resolution", "test.frequency_resolution_Hz"},
    {"shaker.resistance", "shaker.resistance_Ohm"},
    {"shaker.inductance", "shaker.inductance_H"},
    {"shaker.force_factor", "shaker.force_factor_N_per_A"},
    {"shaker.moving_mass", "shaker.moving_mass_kg"},
    {"shaker.suspension_stiffness", "shaker.suspension_stiffness_N_per_m"},
    {"shaker.suspension_damping", "shaker.suspension_damping_Ns_per_m"},
    {"shaker.stinger_stiffness", "shaker.stinger_stiffness_N_per_m"},
    {"noise.force", "noise.force_N"},
    {"noise.acceleration", "noise.acceleration_m_per_s2"},
    {"noise.vibrometer", "noise.vibrometer_m"},
}};

}  // namespace

std::string rig_key(const std::string& field) {
  const std::size_t begin = std::min(field.find('['), field.size());
  const std::size_t end = std::min(field.find('.', begin), field.size());
  const std::string plain = field.substr(0, begin) + field.substr(end);
  for (const auto& [name, key] : kKeys) {
    if (name != plain) continue;
    const std::size_t dot = std::min(key.find('.'), key.size());
    return fmt::format("{}{}{}", key.substr(0, dot), field.substr(begin, end - begin),
                       key.substr(dot));
  }
  return field;
}

Rig parse_rig(std::string_view text, std::string_view file) {
  const toml::table content = parse_toml(text, file);
  const TomlTable top(content, file);
  check_schema(top.place("schema"), top.text("schema"), kRigKind, "a rig");
  Rig rig = read_tables(top);
  try {
    check_rig(rig);
  } catch (const InputError& error) {
    throw error.renamed(toml_name(content, file, rig_key(error.name())));
  }
  return rig;
}

Rig read_rig(const std::string& path) {
  return parse_rig(read_text(path, kLargestRigFile), input_name(path));
}

}  // namespace microslip
