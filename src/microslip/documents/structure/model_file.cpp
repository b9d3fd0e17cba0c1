// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/model_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_tables.hpp"
#include "microslip/dynamics/structure/further_modes.hpp"
#include "microslip/dynamics/structure/residual_flexibility.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/config/toml_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLargestModelFile = std::size_t{16} << 20U;

// Beyond all that vibrates, and far from where squares overflow.
constexpr double kLargestShape = 1e9;          // kg^−½, the tip of a mass of 1e-18 kg
constexpr double kSmallestShape = 1e-9;        // kg^−½
constexpr double kLargestCompliance = 1e15;    // m/N
constexpr double kLargestShortening = 1e18;    // 1/(kg m)
constexpr double kLargestParticipation = 1e9;  // kg^½, the root of a mass
constexpr double kLargestMotion = 1e6;         // over that of a base

constexpr std::string_view kAttachmentsKey = "static_attachments";

std::vector<double> read_shape(const TomlTable& table, std::size_t modes) {
  std::vector<double> shape = read_signed(table, "shape", kLargestShape);
  if (shape.size() == modes) return shape;
  throw wrong_count(table, "shape", shape.size(),
                    fmt::format("must have {}, one per mode of structure.frequency_Hz", modes));
}

/// A shape of zeros is a mistake: the joint or the force would have no effect.
void require_motion(const TomlTable& table, const std::vector<double>& shape) {
  const auto is_small = [](double value) { return std::abs(value) < kSmallestShape; };
  if (!std::ranges::all_of(shape, is_small)) return;
  throw InputError(table.name("shape"), "0 in all modes",
                   fmt::format("must be {:g} or more in at least one mode", kSmallestShape));
}

// ---- The linear part. ----

/// One value a mode.
ModalDamping read_structure_damping(const TomlTable& structure, std::size_t modes) {
  ModalDamping damping = read_damping(structure, "structure", "frequency_Hz");
  if (damping.loss_factor.size() == 1) damping.loss_factor.resize(modes, damping.loss_factor[0]);
  if (damping.loss_factor.size() == modes) return damping;
  throw wrong_count(structure, damping.key, damping.loss_factor.size(),
                    fmt::format("must have {}, one per mode of structure.frequency_Hz{}", modes,
                                modes == 1 ? "" : ", or 1 for all"));
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
    throw InputError(structure.name("point"), "an empty array", "must have at least one point",
                     "Write [[structure.point]] with name and shape.");
  }
  return points;
}

std::vector<ModalBase> read_bases(const TomlTable& structure, std::size_t modes,
                                  const std::vector<ModalPoint>& points) {
  std::vector<ModalBase> bases;
  if (!structure.has("base")) return bases;
  for (const TomlTable& table : structure.tables("base")) {
    table.allow_only({"name", "participation", "point_motion"});
    std::string name = table.text("name");
    check_name(table, name, points, "structure.point");
    check_name(table, name, bases, "structure.base");
    bases.push_back({std::move(name), read_signed(table, "participation", kLargestParticipation),
                     read_signed(table, "point_motion", kLargestMotion)});
    const ModalBase& base = bases.back();
    if (base.participation.size() != modes) {
      throw wrong_count(table, "participation", base.participation.size(),
                        fmt::format("must have {}, one per mode of structure.frequency_Hz", modes));
    }
    if (base.point_motion.size() != points.size()) {
      throw wrong_count(table, "point_motion", base.point_motion.size(),
                        fmt::format("must have {}, one per structure.point", points.size()));
    }
    if (std::ranges::all_of(base.participation, is_zero)) {
      throw InputError(table.name("participation"), "0 in all modes",
                       "must be other than 0 in at least one mode");
    }
  }
  return bases;
}

/// Relative standard deviations, one per mode.
std::vector<double> read_spread(const TomlTable& structure, std::string_view key,
                                std::size_t modes) {
  if (!structure.has(key)) return {};
  std::vector<double> spread = read_positive(structure, key, kLargestSpread);
  if (spread.size() == 1) spread.resize(modes, spread[0]);
  if (spread.size() == modes) return spread;
  throw wrong_count(
      structure, key, spread.size(),
      fmt::format("must have {}, one per mode of structure.frequency_Hz, or 1 for all", modes));
}

template <class Named>
std::vector<std::string> names_of(std::span<const Named> named) {
  std::vector<std::string> names;
  for (const Named& one : named) names.push_back(one.name);
  return names;
}

/// Number of modes that represent those left out; nothing where it is not given.
std::optional<std::size_t> read_attachments(const TomlTable& structure,
                                            const std::vector<Mode>& modes) {
  if (!structure.has(kAttachmentsKey)) return std::nullopt;
  const std::size_t count = structure.whole(kAttachmentsKey);
  if (count >= modes.size()) {
    throw InputError(structure.name(kAttachmentsKey), static_cast<double>(count),
                     fmt::format("must be below the number of modes, {}", modes.size()));
  }
  const auto first = modes.end() - static_cast<std::ptrdiff_t>(count);
  const auto slower = [](const Mode& a, const Mode& b) {
    return a.angular_frequency < b.angular_frequency;
  };
  const auto fastest = std::max_element(modes.begin(), first, slower);
  if (count == 0 || !slower(*std::min_element(first, modes.end(), slower), *fastest)) return count;
  throw InputError(structure.name(kAttachmentsKey), static_cast<double>(count),
                   "must be of the last modes, which must be above the others in frequency");
}

std::vector<std::string> read_names(const TomlTable& table, std::string_view key) {
  return table.has(key) ? table.texts(key) : std::vector<std::string>();
}

std::optional<ResidualFlexibility> read_residual(const TomlTable& structure) {
  if (!structure.has("residual")) return std::nullopt;
  const TomlTable table = structure.table("residual");
  table.allow_only({"points", "joints", "compliance_m_per_N"});
  if (structure.has(kAttachmentsKey)) {
    throw InputError(structure.name("residual"), fmt::format("given with {}", kAttachmentsKey),
                     "must not be given: the residual would count twice");
  }
  return ResidualFlexibility{read_names(table, "points"), read_names(table, "joints"),
                             read_signed(table, "compliance_m_per_N", kLargestCompliance)};
}

struct LinearPart {
  ModalModel model;
  DampingLaw law;
  std::vector<double> frequency_spread;
  std::vector<double> loss_factor_spread;
  std::optional<std::size_t> attachments;
  std::optional<ResidualFlexibility> residual;
};

LinearPart read_structure(const TomlTable& structure) {
  structure.allow_only({"frequency_Hz", "damping_ratio", "loss_factor", "point", "base", "residual",
                        "frequency_std", "loss_factor_std", kAttachmentsKey});
  const std::vector<double> frequency = read_positive(structure, "frequency_Hz", kHighestFrequency);
  if (frequency.empty()) {
    throw wrong_count(structure, "frequency_Hz", 0, "must have one per mode, at least 1");
  }
  const ModalDamping damping = read_structure_damping(structure, frequency.size());
  std::vector<Mode> modes;
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    modes.push_back({2.0 * std::numbers::pi * frequency[i], damping.loss_factor[i]});
  }
  std::vector<ModalPoint> points = read_points(structure, frequency.size());
  std::vector<ModalBase> bases = read_bases(structure, frequency.size(), points);
  const std::optional<std::size_t> attachments = read_attachments(structure, modes);
  return {
      ModalModel(std::move(modes), std::move(points), std::move(bases), attachments.value_or(0)),
      damping.law,
      read_spread(structure, "frequency_std", frequency.size()),
      read_spread(structure, "loss_factor_std", frequency.size()),
      attachments,
      read_residual(structure)};
}

// ---- The joints. ----

std::vector<double> read_shortening(const TomlTable& table, std::size_t modes) {
  constexpr std::string_view kKey = "shortening_per_kg_m";
  if (!table.has(kKey)) return {};
  std::vector<double> values = read_signed(table, kKey, kLargestShortening);
  if (values.size() == modes * modes) return values;
  throw wrong_count(
      table, kKey, values.size(),
      fmt::format("must have {}, the rows of a symmetric matrix with one row per mode",
                  modes * modes));
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
      .linear_damping = source.linear_damping};
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
    std::string name = joint_name(table, joints.size(), tables.size());
    check_name(table, name, joints, "joint");
    sources.push_back(read_joint_source(table, file, to_find));
    joints.push_back(read_joint_table(table, std::move(name), sources.back(), modes));
  }
}

/// Modes in place of what those of the file leave out. They are certain.
void add_residual(const ResidualFlexibility& residual, ModelFile& model) {
  const std::vector<FurtherMode> modes = static_modes(model.structure, residual);
  model.structure = with_further_modes(model.structure, modes);
  model.static_attachments = modes.size();
  const auto pad = [&](std::vector<double>& spread) {
    if (!spread.empty()) spread.resize(model.structure.linear().size(), 0.0);
  };
  pad(model.spread.frequency);
  pad(model.spread.loss_factor);
}

ModelFile read_tables(const TomlTable& top, std::string_view file, JointsToFind to_find) {
  top.allow_only(
      {"schema", "structure", "joint", "excitation", "static_load", "response", "accelerometer"});
  LinearPart linear = read_structure(top.table("structure"));
  StructureSpread spread{.frequency = std::move(linear.frequency_spread),
                         .loss_factor = std::move(linear.loss_factor_spread)};
  DrivenPoints driven =
      read_driven_points(top, names_of(linear.model.points()), names_of(linear.model.bases()));
  std::vector<StructuralJoint> joints;
  std::vector<JointSource> sources;
  read_joints(top, file, to_find, linear.model.size(), joints, sources);
  try {
    ModelFile model = make_model(std::move(linear.model), linear.law, std::move(joints),
                                 std::move(sources), std::move(driven), std::move(spread));
    model.static_attachments = linear.attachments;
    if (linear.residual) add_residual(*linear.residual, model);
    return model;
  } catch (const InputError& error) {  // rules on several keys
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
  return parse_model(read_text(path, kLargestModelFile), input_name(path), to_find);
}

}  // namespace microslip
