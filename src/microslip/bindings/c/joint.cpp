// SPDX-License-Identifier: MIT
#include "microslip/joint/joint.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/version.hpp"
#include "microslip/bindings/c/errors.hpp"
#include "microslip/bindings/c/handles.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace c = microslip::c;

namespace microslip::c {
namespace {

std::vector<double> copied(const microslip_part& part, const double* from, std::size_t index,
                           std::string_view member) {
  const std::span<const double> all =
      values(part.count, from, fmt::format("parts[{}].{}", index, member));
  return {all.begin(), all.end()};
}

/// @param stiffness  of the joint, which Segalman's part has too.
DensityPart density_part(const microslip_part& part, std::size_t index, double stiffness) {
  switch (part.kind) {
    case MICROSLIP_PART_UNIFORM:
      return UniformPart{part.from, part.to, part.weight};
    case MICROSLIP_PART_POWER_LAW:
      return PowerLawPart{part.coefficient, part.exponent, part.from, part.to};
    case MICROSLIP_PART_PIECEWISE_LINEAR:
      return PiecewiseLinearPart{copied(part, part.slip_force, index, "slip_force"),
                                 copied(part, part.value, index, "value")};
    case MICROSLIP_PART_ATOMS:
      return AtomsPart{copied(part, part.slip_force, index, "slip_force"),
                       copied(part, part.value, index, "value")};
    case MICROSLIP_PART_FOUR_PARAMETER:
      return FourParameterPart{part.macroslip_force, stiffness, part.chi, part.beta};
  }
  throw_unknown(part.kind, fmt::format("parts[{}].kind", index));
}

/// @throws InputError  unless a part has the size that is the stride of all parts.
void check_part_size(const microslip_part& part, std::size_t index, std::size_t size) {
  if (part.struct_size == size) return;
  throw InputError(fmt::format("parts[{}]->struct_size", index),
                   fmt::format("{}", part.struct_size),
                   fmt::format("must be that of the first part, {}", size),
                   "Fill each part by microslip_part_defaults().");
}

/// The stride of the parts is the size of the caller's struct.
std::vector<DensityPart> density_parts(double stiffness, const microslip_part* parts,
                                       std::size_t count) {
  std::vector<DensityPart> all;
  if (count == 0) return all;
  const std::size_t size = at(parts, "parts").struct_size;
  const auto* bytes = reinterpret_cast<const unsigned char*>(parts);
  for (std::size_t i = 0; i < count; ++i) {
    const auto* part = reinterpret_cast<const microslip_part*>(bytes + i * size);
    check_part_size(*part, i, size);
    all.push_back(density_part(read_struct(part, microslip_part{}, fmt::format("parts[{}]", i)), i,
                               stiffness));
  }
  return all;
}

/// Translates the names of the parts in messages of the density.
SlipDensity density_of(std::vector<DensityPart> parts) {
  try {
    return SlipDensity(std::move(parts));
  } catch (const InputError& error) {
    std::string name = error.name();
    if (name.starts_with("density[")) name.replace(0, 7, "parts");
    throw error.renamed(name);
  }
}

microslip_joint* new_joint(JointFile file) {
  return new microslip_joint(std::make_shared<const JointFile>(std::move(file)));
}

microslip_part part_of(const DensityPart& part) {
  microslip_part all{};
  if (const auto* uniform = std::get_if<UniformPart>(&part)) {
    all.kind = MICROSLIP_PART_UNIFORM;
    all.from = uniform->from;
    all.to = uniform->to;
    all.weight = uniform->weight;
  } else if (const auto* law = std::get_if<PowerLawPart>(&part)) {
    all.kind = MICROSLIP_PART_POWER_LAW;
    all.coefficient = law->coefficient;
    all.exponent = law->exponent;
    all.from = law->from;
    all.to = law->to;
  } else if (const auto* linear = std::get_if<PiecewiseLinearPart>(&part)) {
    all.kind = MICROSLIP_PART_PIECEWISE_LINEAR;
    all.count = linear->slip_force.size();
    all.slip_force = linear->slip_force.data();
    all.value = linear->density.data();
  } else if (const auto* atoms = std::get_if<AtomsPart>(&part)) {
    all.kind = MICROSLIP_PART_ATOMS;
    all.count = atoms->slip_force.size();
    all.slip_force = atoms->slip_force.data();
    all.value = atoms->weight.data();
  } else if (const auto* segalman = std::get_if<FourParameterPart>(&part)) {
    all.kind = MICROSLIP_PART_FOUR_PARAMETER;
    all.macroslip_force = segalman->macroslip_force;
    all.chi = segalman->chi;
    all.beta = segalman->beta;
  }
  return all;
}

const std::string& text_of(const microslip_joint& joint) {
  std::call_once(joint.written, [&] { joint.text = format_joint(*joint.file); });
  return joint.text;
}

/// With the version of the library where the joint has no provenance of its own: a file without one
/// was not written here, and would not be replaced.
std::string text_to_write(const microslip_joint& joint) {
  if (joint.file->provenance) return text_of(joint);
  JointFile file = *joint.file;
  file.provenance.emplace().version = kVersion;
  file.provenance->command = "microslip_joint_write";
  return format_joint(file);
}

/// Checked before the first value is written, so that the arrays may be one.
template <typename Function>
void each_value(const microslip_joint* joint, std::size_t count, const double* from,
                std::string_view from_name, double least, double* to, std::string_view to_name,
                const Function& function) {
  const Joint& of = at(joint, "joint").file->joint;
  const std::span<const double> all = values(count, from, from_name);
  const std::span<double> results = room(count, to, to_name);
  for (std::size_t i = 0; i < count; ++i) {
    if (all[i] >= least) continue;
    not_negative(all[i], fmt::format("{}[{}]", from_name, i));
  }
  for (std::size_t i = 0; i < count; ++i) results[i] = function(of, all[i]);
}

constexpr double kAny = -HUGE_VAL;

}  // namespace
}  // namespace microslip::c

microslip_status microslip_part_defaults(microslip_part* part, std::size_t struct_size) {
  return c::done([&] { c::write_struct(microslip_part{}, part, struct_size, "part"); });
}

microslip_status microslip_joint_create(double stiffness, const microslip_part* parts,
                                        std::size_t count, microslip_joint** joint) {
  return c::done([&] {
    c::require_pointer(joint, "joint");
    c::positive(stiffness, "stiffness");
    microslip::SlipDensity density = c::density_of(c::density_parts(stiffness, parts, count));
    *joint = c::new_joint({microslip::Joint(stiffness, std::move(density)), {}, {}});
  });
}

microslip_status microslip_joint_read(const char* path, microslip_joint** joint) {
  return c::done([&] {
    c::require_pointer(joint, "joint");
    *joint = c::new_joint(microslip::read_joint(&c::at(path, "path")));
  });
}

microslip_status microslip_joint_parse(const char* text, microslip_joint** joint) {
  return c::done([&] {
    c::require_pointer(joint, "joint");
    *joint = c::new_joint(microslip::parse_joint(&c::at(text, "text"), "text"));
  });
}

microslip_status microslip_joint_write(const microslip_joint* joint, const char* path) {
  return c::done([&] {
    c::require_pointer(path, "path");
    microslip::write_file(path, c::text_to_write(c::at(joint, "joint")));
  });
}

microslip_status microslip_joint_text(const microslip_joint* joint, const char** text) {
  return c::done([&] { c::at(text, "text") = c::text_of(c::at(joint, "joint")).c_str(); });
}

void microslip_joint_destroy(microslip_joint* joint) { delete joint; }

microslip_status microslip_joint_stiffness(const microslip_joint* joint, double* stiffness) {
  return c::done(
      [&] { c::at(stiffness, "stiffness") = c::at(joint, "joint").file->joint.stiffness(); });
}

microslip_status microslip_joint_part_count(const microslip_joint* joint, std::size_t* count) {
  return c::done(
      [&] { c::at(count, "count") = c::at(joint, "joint").file->joint.density().parts().size(); });
}

microslip_status microslip_joint_part(const microslip_joint* joint, std::size_t index,
                                      microslip_part* part) {
  return c::done([&] {
    const auto parts = c::at(joint, "joint").file->joint.density().parts();
    const microslip_part found = c::part_of(parts[c::index_below(index, parts.size(), "index")]);
    c::write_struct(found, part, c::at(part, "part").struct_size, "part");
  });
}

microslip_status microslip_virgin_force(const microslip_joint* joint, std::size_t count,
                                        const double* displacement, double* force) {
  return c::done([&] {
    c::each_value(joint, count, displacement, "displacement", c::kAny, force, "force",
                  [](const microslip::Joint& of, double x) { return of.virgin_force(x); });
  });
}

microslip_status microslip_tangent_stiffness(const microslip_joint* joint, std::size_t count,
                                             const double* displacement, double* stiffness) {
  return c::done([&] {
    c::each_value(joint, count, displacement, "displacement", c::kAny, stiffness, "stiffness",
                  [](const microslip::Joint& of, double x) { return of.tangent_stiffness(x); });
  });
}

microslip_status microslip_dissipation(const microslip_joint* joint, std::size_t count,
                                       const double* amplitude, double* energy) {
  return c::done([&] {
    c::each_value(joint, count, amplitude, "amplitude", 0.0, energy, "energy",
                  microslip::dissipation);
  });
}

microslip_status microslip_secant_stiffness(const microslip_joint* joint, std::size_t count,
                                            const double* amplitude, double* stiffness) {
  return c::done([&] {
    c::each_value(joint, count, amplitude, "amplitude", 0.0, stiffness, "stiffness",
                  microslip::secant_stiffness);
  });
}

microslip_status microslip_density(const microslip_joint* joint, std::size_t count,
                                   const double* slip_force, double* density) {
  return c::done([&] {
    c::each_value(joint, count, slip_force, "slip_force", 0.0, density, "density",
                  [](const microslip::Joint& of, double s) { return of.density().density(s); });
  });
}
