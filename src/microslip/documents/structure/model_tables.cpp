// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/model_tables.hpp"

#include <cmath>
#include <complex>
#include <utility>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/bytes/closest_name.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/config/structured_input.hpp"

namespace microslip {
namespace {

constexpr double kLargestHarmonic = 1e6;     // 1
constexpr double kLargestStaticLoad = 1e12;  // N, m/s²

/// A spring in place of a joint that is to be found.
JointSource read_joint_to_find(const TomlTable& table, JointsToFind to_find) {
  if (to_find == JointsToFind::kRefused) {
    throw FormatError(table.place(kStiffnessKey), "a joint with the key file",
                      "one to be identified, with stiffness_N_per_m in its place",
                      "Identify it first with calibrate, or name its joint.json.");
  }
  const double stiffness = table.number(kStiffnessKey);
  if (!(stiffness >= kSmallestStiffness && stiffness <= kLargestStiffness)) {
    throw InputError(
        table.name(kStiffnessKey), stiffness,
        fmt::format("must be from {:g} to {:g}", kSmallestStiffness, kLargestStiffness),
        "Give the stiffness of the stuck joint.");
  }
  return {"", Joint(stiffness, SlipDensity()), {}, {}, {}, 0.0};
}

JointSource read_source(const TomlTable& table, std::string_view model, JointsToFind to_find) {
  if (table.has(kStiffnessKey) && table.has("file")) {
    throw FormatError(table.place(kStiffnessKey), "file or stiffness_N_per_m", "both",
                      "A joint.json contains the stiffness of its joint.");
  }
  if (table.has(kStiffnessKey)) {
    if (table.has(kSamplesKey)) {
      throw FormatError(table.place(kSamplesKey), "samples of a joint with the key file",
                        "those of one still to be identified", "Leave samples out.");
    }
    return read_joint_to_find(table, to_find);
  }
  std::string path = path_beside(table, "file", "a joint file", model);
  JointFile content = read_named(table, "file", path, read_joint);
  std::string samples;
  if (table.has(kSamplesKey)) samples = path_beside(table, kSamplesKey, "a file of draws", model);
  return {std::move(path),     std::move(content.joint),
          covered_to(content), identified_damping(content),
          std::move(samples),  0.0};
}

// ---- Excitation and response. ----

using PointNames = std::span<const std::string>;

/// One of the names by a key.
/// @param what  "a point", "a base".
std::string read_place(const TomlTable& table, std::string_view key, PointNames there,
                       std::string_view what) {
  const std::string place = table.text(key);
  std::vector<std::string_view> names;
  std::string list;
  for (const std::string& one : there) {
    if (one == place) return place;
    names.emplace_back(one);
    list += fmt::format("{}{}", list.empty() ? "" : ", ", one);
  }
  const std::string_view closest = closest_name(place, names);
  const std::string rule =
      there.empty() ? fmt::format("must be the name of {}, and there is none", what)
                    : fmt::format("must be the name of {}: {}", what, in_quotes(list, 120));
  throw InputError(table.name(key), in_quotes(place), rule,
                   closest.empty() ? "" : fmt::format("Did you mean {}?", in_quotes(closest)));
}

std::string read_point(const TomlTable& table, PointNames points) {
  return read_place(table, "point", points, "a point");
}

/// Place of a load: a point by the key point, or a base by the key base.
std::string read_loaded(const TomlTable& table, PointNames points, PointNames bases) {
  if (!table.has("base")) return read_point(table, points);
  if (table.has("point")) {
    throw FormatError(table.place("base"), "one of the keys point and base", "both",
                      "A force acts at a point, an acceleration on a base.");
  }
  return read_place(table, "base", bases, "a base");
}

std::vector<std::complex<double>> read_harmonics(const TomlTable& table) {
  std::vector<double> amplitude{1.0};
  if (table.has("harmonics")) amplitude = read_signed(table, "harmonics", kLargestHarmonic);
  if (std::ranges::all_of(amplitude, is_zero)) {
    throw InputError(table.name("harmonics"), "no harmonic",
                     "must have at least one that is not 0");
  }
  std::vector<double> phase(amplitude.size(), 0.0);
  if (table.has("phase_rad")) phase = read_signed(table, "phase_rad", kLargestHarmonic);
  if (phase.size() != amplitude.size()) {
    throw wrong_count(table, "phase_rad", phase.size(),
                      fmt::format("must have {}, one per harmonic", amplitude.size()));
  }
  std::vector<std::complex<double>> harmonics;
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    harmonics.push_back(amplitude[i] *
                        std::complex<double>(std::cos(phase[i]), std::sin(phase[i])));
  }
  return harmonics;
}

/// The name of a channel. No two the same.
std::string read_channel(const TomlTable& table, std::vector<std::string>& names) {
  std::string channel = table.text("channel");
  if (channel.empty() || std::ranges::find(names, channel) != names.end()) {
    throw InputError(table.name("channel"), in_quotes(channel),
                     "must be a channel of the recordings, each only once");
  }
  return names.emplace_back(std::move(channel));
}

std::vector<PointSensor> read_accelerometers(const TomlTable& top, PointNames points,
                                             std::vector<std::string> names) {
  std::vector<PointSensor> sensors;
  if (!top.has("accelerometer")) return sensors;
  for (const TomlTable& table : top.tables("accelerometer")) {
    table.allow_only({"channel", "point"});
    std::string channel = read_channel(table, names);
    sensors.push_back({std::move(channel), read_point(table, points)});
  }
  return sensors;
}

constexpr std::string_view kGainSpreadKey = "gain_std";

/// @param channels  of their forces, empty where not given.
/// @param gains     spread of the gain of each.
std::vector<Excitation> read_excitations(const TomlTable& top, PointNames points, PointNames bases,
                                         std::vector<std::string>& channels,
                                         std::vector<double>& gains) {
  std::vector<Excitation> excitations;
  std::vector<std::string> names;
  for (const TomlTable& table : top.one_or_more("excitation")) {
    table.allow_only({"point", "base", "harmonics", "phase_rad", "channel", kGainSpreadKey});
    std::string point = read_loaded(table, points, bases);
    channels.push_back(table.has("channel") ? read_channel(table, names) : std::string());
    excitations.push_back({std::move(point), read_harmonics(table)});
    gains.push_back(read_optional(table, kGainSpreadKey, kLargestSpread));
  }
  if (!excitations.empty()) return excitations;
  throw InputError(top.name("excitation"), "an empty array", "must have at least one excitation",
                   "Write [excitation] with point.");
}

/// A force by force_N at a point, an acceleration by acceleration_m_per_s2 of a base.
std::vector<StaticLoad> read_static_loads(const TomlTable& top, PointNames points,
                                          PointNames bases) {
  std::vector<StaticLoad> loads;
  if (!top.has("static_load")) return loads;
  for (const TomlTable& table : top.one_or_more("static_load")) {
    const bool of_base = table.has("base");
    const std::string_view key = of_base ? "acceleration_m_per_s2" : "force_N";
    table.allow_only({"point", "base", key});
    StaticLoad load{read_loaded(table, points, bases), table.number(key)};
    if (!(std::abs(load.value) <= kLargestStaticLoad)) {
      throw InputError(
          table.name(key), load.value,
          fmt::format("must be from {:g} to {:g}", -kLargestStaticLoad, kLargestStaticLoad));
    }
    loads.push_back(std::move(load));
  }
  return loads;
}

std::string read_response(const TomlTable& top, PointNames points, double& gain) {
  const TomlTable response = top.table("response");
  response.allow_only({"point", kGainSpreadKey});
  gain = read_optional(response, kGainSpreadKey, kLargestSpread);
  return read_point(response, points);
}

}  // namespace

std::vector<double> read_positive(const TomlTable& table, std::string_view key, double most) {
  std::vector<double> values = table.numbers(key);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= 0.0 && values[i] <= most) continue;
    throw InputError(table.name(key, i), values[i], fmt::format("must be from 0 to {:g}", most));
  }
  return values;
}

std::vector<double> read_signed(const TomlTable& table, std::string_view key, double most) {
  std::vector<double> values = table.numbers(key);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) <= most) continue;
    throw InputError(table.name(key, i), values[i],
                     fmt::format("must be from {:g} to {:g}", -most, most));
  }
  return values;
}

double read_optional(const TomlTable& table, std::string_view key, double most, double otherwise) {
  if (!table.has(key)) return otherwise;
  const double value = table.number(key);
  if (value >= 0.0 && value <= most) return value;
  throw InputError(table.name(key), value, fmt::format("must be from 0 to {:g}", most));
}

InputError wrong_count(const TomlTable& table, std::string_view key, std::size_t found,
                       const std::string& rule) {
  return {table.name(key), fmt::format("{} value{}", found, found == 1 ? "" : "s"), rule};
}

ModalDamping read_damping(const TomlTable& table, std::string_view section,
                          std::string_view beside) {
  const bool viscous = table.has("damping_ratio");
  if (viscous == table.has("loss_factor")) {
    throw FormatError(table.place(viscous ? "loss_factor" : beside),
                      fmt::format("in {} one of the keys damping_ratio and loss_factor", section),
                      viscous ? "both" : "neither");
  }
  const std::string_view key = viscous ? "damping_ratio" : "loss_factor";
  ModalDamping damping{read_positive(table, key, kLargestLossFactor),
                       viscous ? DampingLaw::kViscous : DampingLaw::kHysteretic, key};
  if (viscous) {
    for (double& value : damping.loss_factor) value *= 2.0;
  }
  return damping;
}

std::string joint_name(const TomlTable& table, std::size_t number, std::size_t count) {
  if (table.has("name")) return table.text("name");
  return count == 1 ? "joint" : fmt::format("joint{}", number + 1);
}

std::string path_beside(const TomlTable& table, std::string_view key, std::string_view what,
                        std::string_view model) {
  const std::string file = table.text(key);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  if (file.empty() || std::ranges::any_of(file, is_control)) {
    throw InputError(table.name(key), in_quotes(file),
                     fmt::format("must be the path of {}, without control characters", what));
  }
  const std::string path = file_beside(std::string(model), file);
  return path == "-" ? "./-" : path;
}

JointSource read_joint_source(const TomlTable& table, std::string_view model,
                              JointsToFind to_find) {
  JointSource source = read_source(table, model, to_find);
  source.normal_load_spread = read_optional(table, kNormalLoadSpreadKey, kLargestSpread);
  source.damping_said = table.has(kLinearDampingKey);
  source.linear_damping = read_optional(table, kLinearDampingKey, kLargestLinearDamping,
                                        source.identified_damping.value_or(0.0));
  return source;
}

DrivenPoints read_driven_points(const TomlTable& top, PointNames points, PointNames bases) {
  DrivenPoints driven;
  driven.excitations = read_excitations(top, points, bases, driven.channels, driven.gain_spreads);
  driven.static_loads = read_static_loads(top, points, bases);
  driven.accelerometers = read_accelerometers(top, points, driven.channels);
  if (top.has("response")) {
    driven.response = read_response(top, points, driven.response_gain_spread);
    return driven;
  }
  driven.response = driven.excitations.front().point;
  if (std::ranges::find(points, driven.response) != points.end()) return driven;
  throw InputError(
      top.name("response"), "left out",
      fmt::format("must name a point: the excitation is that of the base '{}'", driven.response),
      "Write [response] with point.");
}

}  // namespace microslip
