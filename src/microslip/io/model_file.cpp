// SPDX-License-Identifier: MIT
#include "microslip/io/model_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/closest_name.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/structured_input.hpp"
#include "microslip/io/text.hpp"
#include "microslip/io/toml_input.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLargestModelFile = std::size_t{16} << 20U;

// Beyond all that vibrates, and far from where squares overflow.
constexpr double kHighestFrequency = 1e9;    // Hz
constexpr double kLargestLossFactor = 1e3;   // 1
constexpr double kLargestShape = 1e9;        // kg^−½, the tip of a mass of 1e-18 kg
constexpr double kSmallestShape = 1e-9;      // kg^−½
constexpr double kLargestStiffness = 1e15;   // N/m, that of a joint
constexpr double kSmallestStiffness = 1e-6;  // N/m, of a joint that is to be found
constexpr double kLargestCompliance = 1e15;  // m/N
constexpr double kLargestHarmonic = 1e6;     // 1
constexpr double kLargestShortening = 1e18;  // 1/(kg m)
constexpr double kLargestSpread = StructureDraws::kLargestSpread;

/// The numbers of a key, each from 0 to `most`.
std::vector<double> read_positive(const TomlTable& table, std::string_view key, double most) {
  std::vector<double> values = table.numbers(key);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= 0.0 && values[i] <= most) continue;
    throw InputError(table.name(key, i), values[i], fmt::format("must be from 0 to {:g}", most));
  }
  return values;
}

/// The numbers of a key, each up to `most` either way.
std::vector<double> read_signed(const TomlTable& table, std::string_view key, double most) {
  std::vector<double> values = table.numbers(key);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) <= most) continue;
    throw InputError(table.name(key, i), values[i],
                     fmt::format("must be from {:g} to {:g}", -most, most));
  }
  return values;
}

double read_optional(const TomlTable& table, std::string_view key, double most,
                     double otherwise = 0.0) {
  if (!table.has(key)) return otherwise;
  const double value = table.number(key);
  if (value >= 0.0 && value <= most) return value;
  throw InputError(table.name(key), value, fmt::format("must be from 0 to {:g}", most));
}

InputError wrong_count(const TomlTable& table, std::string_view key, std::size_t found,
                       const std::string& rule) {
  return {table.name(key), fmt::format("{} value{}", found, found == 1 ? "" : "s"), rule};
}

std::vector<double> read_shape(const TomlTable& table, std::size_t modes) {
  std::vector<double> shape = read_signed(table, "shape", kLargestShape);
  if (shape.size() == modes) return shape;
  throw wrong_count(table, "shape", shape.size(),
                    fmt::format("must have {}, one a mode of structure.frequency_Hz", modes));
}

bool is_zero(double value) { return value == 0.0; }

/// A shape that moves nothing is a slip of the pen: the joint or the force would have no effect.
void require_motion(const TomlTable& table, const std::vector<double>& shape) {
  const auto is_small = [](double value) { return std::abs(value) < kSmallestShape; };
  if (!std::ranges::all_of(shape, is_small)) return;
  throw InputError(table.name("shape"), "0 in all modes",
                   fmt::format("must be {:g} or more in one mode at least", kSmallestShape));
}

// ---- The linear part. ----

struct Damping {
  std::vector<double> loss_factor;  ///< η = 2ζ, one a mode
  DampingLaw law = DampingLaw::kViscous;
};

Damping read_damping(const TomlTable& structure, std::size_t modes) {
  const bool viscous = structure.has("damping_ratio");
  if (viscous == structure.has("loss_factor")) {
    throw FormatError(structure.place(viscous ? "loss_factor" : "frequency_Hz"),
                      "in structure one of the keys damping_ratio and loss_factor",
                      viscous ? "both" : "neither");
  }
  const std::string_view key = viscous ? "damping_ratio" : "loss_factor";
  Damping damping{read_positive(structure, key, kLargestLossFactor),
                  viscous ? DampingLaw::kViscous : DampingLaw::kHysteretic};
  if (damping.loss_factor.size() == 1) damping.loss_factor.resize(modes, damping.loss_factor[0]);
  if (damping.loss_factor.size() != modes) {
    throw wrong_count(structure, key, damping.loss_factor.size(),
                      fmt::format("must have {}, one a mode of structure.frequency_Hz{}", modes,
                                  modes == 1 ? "" : ", or 1 for all"));
  }
  if (viscous) {
    for (double& value : damping.loss_factor) value *= 2.0;
  }
  return damping;
}

/// Not empty, and other than those of the tables `others` before it.
template <class Named>
void check_name(const TomlTable& table, const std::string& name, const std::vector<Named>& before,
                std::string_view others) {
  // It stands in the header of tables.
  if (name.empty() || name.find_first_of("[],;\"#\t\r\n") != std::string::npos) {
    throw InputError(table.name("name"), in_quotes(name),
                     "must be a text, without [ ] , ; \" # and tabs");
  }
  const auto same = std::ranges::find(before, name, &Named::name);
  if (same == before.end()) return;
  throw InputError(table.name("name"), in_quotes(name),
                   fmt::format("must differ from {}[{}].name", others, same - before.begin()));
}

std::vector<ModalPoint> read_points(const TomlTable& structure, std::size_t modes) {
  std::vector<ModalPoint> points;
  for (const TomlTable& table : structure.tables("point")) {
    table.allow_only({"name", "shape"});
    std::string name = table.text("name");
    check_name(table, name, points, "structure.point");
    points.push_back({std::move(name), read_shape(table, modes)});
    require_motion(table, points.back().shape);
  }
  if (points.empty()) {
    throw InputError(structure.name("point"), "an empty array", "must have one point at least",
                     "Write [[structure.point]] with name and shape.");
  }
  return points;
}

/// Relative standard deviations, one a mode.
std::vector<double> read_spread(const TomlTable& structure, std::string_view key,
                                std::size_t modes) {
  if (!structure.has(key)) return {};
  std::vector<double> spread = read_positive(structure, key, kLargestSpread);
  if (spread.size() == 1) spread.resize(modes, spread[0]);
  if (spread.size() == modes) return spread;
  throw wrong_count(
      structure, key, spread.size(),
      fmt::format("must have {}, one a mode of structure.frequency_Hz, or 1 for all", modes));
}

struct LinearPart {
  ModalModel model;
  DampingLaw law;
  std::vector<double> frequency_spread;
  std::vector<double> loss_factor_spread;
};

LinearPart read_structure(const TomlTable& structure) {
  structure.allow_only({"frequency_Hz", "damping_ratio", "loss_factor", "point", "frequency_std",
                        "loss_factor_std"});
  const std::vector<double> frequency = read_positive(structure, "frequency_Hz", kHighestFrequency);
  if (frequency.empty()) {
    throw wrong_count(structure, "frequency_Hz", 0, "must have one a mode, 1 at least");
  }
  const Damping damping = read_damping(structure, frequency.size());
  std::vector<Mode> modes;
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    modes.push_back({2.0 * std::numbers::pi * frequency[i], damping.loss_factor[i]});
  }
  return {ModalModel(std::move(modes), read_points(structure, frequency.size())), damping.law,
          read_spread(structure, "frequency_std", frequency.size()),
          read_spread(structure, "loss_factor_std", frequency.size())};
}

// ---- The joints. ----

/// Relative to the folder of the model. A file that is called - is no standard input.
std::string path_beside(const TomlTable& table, std::string_view key, std::string_view what,
                        std::string_view model) {
  const std::string file = table.text(key);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  if (file.empty() || std::ranges::any_of(file, is_control)) {
    throw InputError(table.name(key), in_quotes(file),
                     fmt::format("must be the path of {}, without control characters", what));
  }
  const std::string path = (std::filesystem::path(model).parent_path() / file).string();
  return path == "-" ? "./-" : path;
}

JointFile read_joint_of(const TomlTable& table, const std::string& path) {
  try {
    return read_joint(path);
  } catch (const FileError& error) {
    throw FileError(table.name("file"), error.what());
  }
}

std::vector<double> read_shortening(const TomlTable& table, std::size_t modes) {
  constexpr std::string_view kKey = "shortening_per_kg_m";
  if (!table.has(kKey)) return {};
  std::vector<double> values = read_signed(table, kKey, kLargestShortening);
  if (values.size() == modes * modes) return values;
  throw wrong_count(table, kKey, values.size(),
                    fmt::format("must have {}, the rows of a symmetric matrix with one row a mode",
                                modes * modes));
}

/// A joint, and where it comes from.
struct JointSource {
  std::string file;  ///< empty for a joint that is to be found
  Joint joint;
  std::optional<double> covered_to;          ///< N
  std::optional<double> identified_damping;  ///< J/m²
  std::string samples = {};                  ///< file of its draws; empty without
  double normal_load_spread = 0.0;           ///< relative standard deviation
  bool damping_said = false;                 ///< by the model, whatever was identified
};

constexpr std::string_view kStiffnessKey = "stiffness_N_per_m";
constexpr std::string_view kSamplesKey = "samples";
constexpr std::string_view kNormalLoadSpreadKey = "normal_load_std";

/// A spring in place of a joint that is to be found.
JointSource read_joint_to_find(const TomlTable& table, JointsToFind to_find) {
  if (to_find == JointsToFind::kRefused) {
    throw FormatError(table.place(kStiffnessKey), "a joint with the key file",
                      "one that is to be found, with stiffness_N_per_m in its place",
                      "Find it first, by calibrate, or name its joint.json.");
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

JointSource read_joint_source(const TomlTable& table, std::string_view model,
                              JointsToFind to_find) {
  if (table.has(kStiffnessKey) && table.has("file")) {
    throw FormatError(table.place(kStiffnessKey), "file or stiffness_N_per_m", "both",
                      "A joint.json has the stiffness of its joint.");
  }
  if (table.has(kStiffnessKey)) {
    if (table.has(kSamplesKey)) {
      throw FormatError(table.place(kSamplesKey), "samples of a joint with the key file",
                        "those of one that is still to be found", "Leave samples out.");
    }
    return read_joint_to_find(table, to_find);
  }
  std::string path = path_beside(table, "file", "a joint file", model);
  JointFile content = read_joint_of(table, path);
  std::string samples;
  if (table.has(kSamplesKey)) samples = path_beside(table, kSamplesKey, "a file of draws", model);
  return {std::move(path),     std::move(content.joint),
          covered_to(content), identified_damping(content),
          std::move(samples),  0.0};
}

/// The joint itself comes from its file, and its linear damping where the model does not say.
StructuralJoint read_joint_table(const TomlTable& table, std::string name,
                                 const JointSource& source, std::size_t modes) {
  StructuralJoint result{
      .name = std::move(name),
      .joint = source.joint,
      .shape = read_shape(table, modes),
      .spring_in_modes = read_optional(table, "spring_in_modes_N_per_m", kLargestStiffness),
      .series_compliance = read_optional(table, "series_compliance_m_per_N", kLargestCompliance),
      .shortening = read_shortening(table, modes),
      .linear_damping = read_optional(table, kLinearDampingKey, kLargestLinearDamping,
                                      source.identified_damping.value_or(0.0))};
  if (std::ranges::all_of(result.shortening, is_zero)) require_motion(table, result.shape);
  return result;
}

void read_joints(const TomlTable& top, std::string_view file, JointsToFind to_find,
                 std::size_t modes, std::vector<StructuralJoint>& joints,
                 std::vector<JointSource>& sources) {
  if (!top.has("joint")) return;
  const std::vector<TomlTable> tables = top.tables("joint");
  for (const TomlTable& table : tables) {
    table.allow_only({"file", kStiffnessKey, "shape", "name", "spring_in_modes_N_per_m",
                      "series_compliance_m_per_N", "shortening_per_kg_m", kLinearDampingKey,
                      kSamplesKey, kNormalLoadSpreadKey});
    std::string name = tables.size() == 1 ? "joint" : fmt::format("joint{}", joints.size() + 1);
    if (table.has("name")) name = table.text("name");
    check_name(table, name, joints, "joint");
    sources.push_back(read_joint_source(table, file, to_find));
    sources.back().normal_load_spread = read_optional(table, kNormalLoadSpreadKey, kLargestSpread);
    sources.back().damping_said = table.has(kLinearDampingKey);
    joints.push_back(read_joint_table(table, std::move(name), sources.back(), modes));
  }
}

// ---- Excitation and response. ----

std::string read_point(const TomlTable& table, const ModalModel& model) {
  const std::string point = table.text("point");
  std::vector<std::string_view> names;
  std::string list;
  for (const ModalPoint& there : model.points()) {
    if (there.name == point) return point;
    names.push_back(there.name);
    list += fmt::format("{}{}", list.empty() ? "" : ", ", there.name);
  }
  const std::string_view closest = closest_name(point, names);
  throw InputError(table.name("point"), in_quotes(point),
                   fmt::format("must be the name of a structure.point: {}", in_quotes(list, 120)),
                   closest.empty() ? "" : fmt::format("Is it to be {}?", in_quotes(closest)));
}

std::vector<std::complex<double>> read_harmonics(const TomlTable& table) {
  std::vector<double> amplitude{1.0};
  if (table.has("harmonics")) amplitude = read_signed(table, "harmonics", kLargestHarmonic);
  if (std::ranges::all_of(amplitude, is_zero)) {
    throw InputError(table.name("harmonics"), "no harmonic", "must have one that is not 0");
  }
  std::vector<double> phase(amplitude.size(), 0.0);
  if (table.has("phase_rad")) phase = read_signed(table, "phase_rad", kLargestHarmonic);
  if (phase.size() != amplitude.size()) {
    throw wrong_count(table, "phase_rad", phase.size(),
                      fmt::format("must have {}, one a harmonic", amplitude.size()));
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
                     "must be a channel of the recordings, and no two the same");
  }
  return names.emplace_back(std::move(channel));
}

std::vector<PointSensor> read_accelerometers(const TomlTable& top, const ModalModel& model,
                                             std::vector<std::string> names) {
  std::vector<PointSensor> sensors;
  if (!top.has("accelerometer")) return sensors;
  for (const TomlTable& table : top.tables("accelerometer")) {
    table.allow_only({"channel", "point"});
    std::string channel = read_channel(table, names);
    sensors.push_back({std::move(channel), read_point(table, model)});
  }
  return sensors;
}

constexpr std::string_view kGainSpreadKey = "gain_std";

/// @param channels  of their forces, empty where one is not told.
/// @param gains     spread of the gain of each.
std::vector<Excitation> read_excitations(const TomlTable& top, const ModalModel& model,
                                         std::vector<std::string>& channels,
                                         std::vector<double>& gains) {
  std::vector<Excitation> excitations;
  std::vector<std::string> names;
  for (const TomlTable& table : top.one_or_more("excitation")) {
    table.allow_only({"point", "harmonics", "phase_rad", "channel", kGainSpreadKey});
    std::string point = read_point(table, model);
    channels.push_back(table.has("channel") ? read_channel(table, names) : std::string());
    excitations.push_back({std::move(point), read_harmonics(table)});
    gains.push_back(read_optional(table, kGainSpreadKey, kLargestSpread));
  }
  if (!excitations.empty()) return excitations;
  throw InputError(top.name("excitation"), "an empty array", "must have one excitation at least",
                   "Write [excitation] with point.");
}

std::string read_response(const TomlTable& top, const ModalModel& model, double& gain) {
  const TomlTable response = top.table("response");
  response.allow_only({"point", kGainSpreadKey});
  gain = read_optional(response, kGainSpreadKey, kLargestSpread);
  return read_point(response, model);
}

ModelFile read_tables(const TomlTable& top, std::string_view file, JointsToFind to_find) {
  top.allow_only({"schema", "structure", "joint", "excitation", "response", "accelerometer"});
  LinearPart linear = read_structure(top.table("structure"));
  std::vector<std::string> channels;
  StructureSpread spread{.frequency = std::move(linear.frequency_spread),
                         .loss_factor = std::move(linear.loss_factor_spread)};
  std::vector<Excitation> excitations =
      read_excitations(top, linear.model, channels, spread.force_gain);
  std::vector<PointSensor> sensors = read_accelerometers(top, linear.model, channels);
  std::string response = top.has("response")
                             ? read_response(top, linear.model, spread.response_gain)
                             : excitations.front().point;
  std::vector<StructuralJoint> joints;
  std::vector<JointSource> sources;
  read_joints(top, file, to_find, linear.model.size(), joints, sources);
  try {
    ModelFile model{JointedStructure(std::move(linear.model), std::move(joints),
                                     std::move(excitations), linear.law),
                    std::move(response),
                    {}};
    for (JointSource& source : sources) {
      if (source.file.empty()) model.to_find.push_back(model.joint_files.size());
      model.joint_files.push_back(std::move(source.file));
      model.covered_to.push_back(source.covered_to);
      model.identified_damping.push_back(source.identified_damping);
      model.joint_samples.push_back(std::move(source.samples));
      model.damping_said.push_back(source.damping_said);
      spread.normal_load.push_back(source.normal_load_spread);
    }
    model.spread = std::move(spread);
    model.force_channels = std::move(channels);
    model.accelerometers = std::move(sensors);
    return model;
  } catch (const InputError& error) {  // what concerns several keys
    throw error.renamed(fmt::format("{}: {}", file, error.name()));
  }
}

}  // namespace

ModelFile parse_model(std::string_view text, std::string_view file, JointsToFind to_find) {
  const toml::table content = parse_toml(text, file);
  const TomlTable top(content, file);
  check_schema(top.place("schema"), top.text("schema"), kModelKind, "a model");
  return read_tables(top, file, to_find);
}

ModelFile read_model(const std::string& path, JointsToFind to_find) {
  return parse_model(read_file(path, kLargestModelFile), input_name(path), to_find);
}

}  // namespace microslip
