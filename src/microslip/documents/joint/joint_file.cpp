// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/joint_file.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/json_input.hpp"
#include "microslip/io/config/named_value_access.hpp"
#include "microslip/io/config/named_values_json.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLargestJointFile = std::size_t{256} << 20U;

// ---- From JSON to a joint. ----

DensityPart read_uniform(const JsonObject& part) {
  part.allow_only({"type", "from_N", "to_N", "weight"});
  return UniformPart{
      .from = part.number("from_N"), .to = part.number("to_N"), .weight = part.number("weight")};
}

DensityPart read_power_law(const JsonObject& part) {
  part.allow_only({"type", "coefficient", "exponent", "from_N", "to_N"});
  return PowerLawPart{.coefficient = part.number("coefficient"),
                      .exponent = part.number("exponent"),
                      .from = part.number("from_N"),
                      .to = part.number("to_N")};
}

DensityPart read_piecewise_linear(const JsonObject& part) {
  part.allow_only({"type", "slip_force_N", "density_per_N"});
  return PiecewiseLinearPart{.slip_force = part.numbers("slip_force_N"),
                             .density = part.numbers("density_per_N")};
}

DensityPart read_atoms(const JsonObject& part) {
  part.allow_only({"type", "slip_force_N", "weight"});
  return AtomsPart{.slip_force = part.numbers("slip_force_N"), .weight = part.numbers("weight")};
}

DensityPart read_four_parameter(const JsonObject& part, double stiffness) {
  part.allow_only({"type", "macroslip_force_N", "chi", "beta"});
  return FourParameterPart{.macroslip_force = part.number("macroslip_force_N"),
                           .stiffness = stiffness,
                           .chi = part.number("chi"),
                           .beta = part.number("beta")};
}

DensityPart read_part(const JsonObject& part, double stiffness) {
  const std::string type = part.text("type");
  if (type == "uniform") return read_uniform(part);
  if (type == "power_law") return read_power_law(part);
  if (type == "piecewise_linear") return read_piecewise_linear(part);
  if (type == "atoms") return read_atoms(part);
  if (type == "four_parameter") return read_four_parameter(part, stiffness);
  throw InputError(part.name("type"), in_quotes(type),
                   "must be uniform, power_law, piecewise_linear, atoms or four_parameter");
}

/// The key in the file for a name in an error of SlipDensity or Joint: density[2].to is
/// density[2].to_N there, and density[0].slip_force[1] is density[0].slip_force_N[1].
std::string key_name(const std::string& name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kKeys{{
      {"from", "from_N"},
      {"to", "to_N"},
      {"slip_force", "slip_force_N"},
      {"density", "density_per_N"},
      {"macroslip_force", "macroslip_force_N"},
  }};
  const std::size_t dot = name.find('.');
  const std::string field = dot == std::string::npos ? name : name.substr(dot + 1);
  if (field == "stiffness") return "stiffness_N_per_m";
  if (dot == std::string::npos) return name;
  const std::size_t bracket = std::min(field.find('['), field.size());
  for (const auto& [member, key] : kKeys) {
    if (field.substr(0, bracket) != member) continue;
    return fmt::format("{}.{}{}", name.substr(0, dot), key, field.substr(bracket));
  }
  return name;
}

Joint make_joint(double stiffness, std::vector<DensityPart> parts, std::string_view file) {
  try {
    return Joint(stiffness, SlipDensity(std::move(parts)));
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", file, key_name(error.name())));
  }
}

Joint read_joint_object(const JsonObject& top, std::string_view file) {
  const double stiffness = top.number("stiffness_N_per_m");
  std::vector<DensityPart> parts;
  for (const Json& value : top.array("density")) {
    const JsonObject part(value, file, fmt::format("density[{}]", parts.size()));
    parts.push_back(read_part(part, stiffness));
  }
  return make_joint(stiffness, std::move(parts), file);
}

// ---- From a joint to JSON. ----

class PartWriter {
 public:
  explicit PartWriter(std::string& text) : text_(text) {}

  void operator()(const UniformPart& part) const {
    begin("uniform");
    add("from_N", part.from);
    add("to_N", part.to);
    add("weight", part.weight);
  }

  void operator()(const PowerLawPart& part) const {
    begin("power_law");
    add("coefficient", part.coefficient);
    add("exponent", part.exponent);
    add("from_N", part.from);
    add("to_N", part.to);
  }

  void operator()(const PiecewiseLinearPart& part) const {
    begin("piecewise_linear");
    add("slip_force_N", part.slip_force);
    add("density_per_N", part.density);
  }

  void operator()(const AtomsPart& part) const {
    begin("atoms");
    add("slip_force_N", part.slip_force);
    add("weight", part.weight);
  }

  void operator()(const FourParameterPart& part) const {
    begin("four_parameter");
    add("macroslip_force_N", part.macroslip_force);
    add("chi", part.chi);
    add("beta", part.beta);
  }

 private:
  void begin(std::string_view type) const { text_ += fmt::format("{{\"type\": \"{}\"", type); }

  void add(std::string_view key, double value) const {
    text_ += fmt::format(", \"{}\": ", key);
    append_number(text_, value);
  }

  void add(std::string_view key, const std::vector<double>& values) const {
    text_ += fmt::format(",\n      \"{}\": ", key);
    append_numbers(text_, values);
  }

  std::string& text_;
};

void append_density(std::string& text, std::span<const DensityPart> parts) {
  text += '[';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += i == 0 ? "\n    " : ",\n    ";
    std::visit(PartWriter(text), parts[i]);
    text += '}';
  }
  text += parts.empty() ? "]" : "\n  ]";
}

/// Predictions take it: what cannot be understood must not pass for nothing.
void check_damping(const JsonObject& identification) {
  if (!identification.has(kLinearDampingKey)) return;
  const double beta = identification.number(kLinearDampingKey);
  if (beta >= 0.0 && beta <= kLargestLinearDamping) return;
  throw InputError(identification.name(kLinearDampingKey), beta,
                   fmt::format("must be from 0 to {:g} J/m^2", kLargestLinearDamping));
}

void append_object(std::string& text, std::string_view key, const NamedValues& record) {
  text += fmt::format(",\n  \"{}\": ", key);
  append_named_values(text, record, "  ");
}

}  // namespace

std::optional<double> covered_to(const JointFile& file) {
  const std::optional<double> force = number_in(file.identification, kCoveredToKey);
  return force > 0.0 ? force : std::nullopt;
}

std::optional<double> identified_damping(const JointFile& file) {
  if (const double viscous = identified_viscous(file); viscous > 0.0) {
    throw InputError(fmt::format("identification.{}", kViscousKey), viscous,
                     "must be 0: predictions do not support a viscous part of a joint",
                     "Identify the joint without it, or include it in the structure's damping "
                     "and remove the key.");
  }
  return number_in(file.identification, kLinearDampingKey);
}

double identified_viscous(const JointFile& file) {
  return number_in(file.identification, kViscousKey).value_or(0.0);
}

JointFile parse_joint(std::string_view text, std::string_view file) {
  const Json json = parse_json(text, file);
  const JsonObject top(json, file, "");
  check_schema({std::string(file), 0, 0}, top.text("schema"), kJointKind, "a joint");
  top.allow_only({"schema", "stiffness_N_per_m", "density", "provenance", "identification"});
  JointFile result{.joint = read_joint_object(top, file), .provenance = {}, .identification = {}};
  for (const char* key : {"provenance", "identification"}) {
    if (top.has(key)) (void)JsonObject(top.at(key), file, key);  // throws where it is no object
  }
  if (top.has("provenance")) result.provenance = read_provenance(top.at("provenance"));
  if (top.has("identification")) {
    check_damping(JsonObject(top.at("identification"), file, "identification"));
    result.identification = read_named_values(top.at("identification"));
  }
  return result;
}

JointFile read_joint(const std::string& path) {
  return parse_joint(read_text(path, kLargestJointFile), input_name(path));
}

std::string format_joint(const JointFile& file) {
  std::string text =
      fmt::format("{{\n  \"schema\": \"{}\",\n  \"stiffness_N_per_m\": ", kJointKind);
  append_number(text, file.joint.stiffness());
  text += ",\n  \"density\": ";
  append_density(text, file.joint.density().parts());
  if (file.provenance) append_object(text, "provenance", provenance_values(*file.provenance));
  if (!file.identification.empty()) append_object(text, "identification", file.identification);
  return text + "\n}\n";
}

}  // namespace microslip
