// SPDX-License-Identifier: MIT
#include "microslip/modes/structure_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "microslip/documents/structure/model_writer.hpp"
#include "microslip/documents/structure/structure_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/relative_path.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/modes/tested_structure_modes.hpp"

namespace microslip {
namespace {

/// Modes shown in a summary: more would fill the screen.
constexpr std::size_t kModesShown = 12;
/// Share of a mode's strain energy in springs across joints above which a warning is given.
constexpr double kSharedSprings = 0.05;

double in_hertz(double angular_frequency) { return angular_frequency / (2.0 * std::numbers::pi); }

ModesOptions options_of(const StructureFile& file, const Progress& progress) {
  ModesOptions options{.count = file.count,
                       .highest_frequency = file.highest_frequency,
                       .joints = file.joints,
                       .attachment = file.attachment,
                       .progress = progress};
  const auto attach = [&](const std::string& place) {
    std::vector<std::string>& attached = options.attached_points;
    if (std::ranges::find(attached, place) == attached.end()) attached.push_back(place);
  };
  for (const Excitation& excitation : file.driven.excitations) attach(excitation.point);
  for (const StaticLoad& load : file.driven.static_loads) attach(load.place);
  return options;
}

ModalModel damped(const ModalModel& model, const std::vector<double>& loss_factor) {
  if (loss_factor.empty()) return model;  // of a test, as measured
  std::vector<Mode> modes(model.modes().begin(), model.modes().end());
  for (std::size_t i = 0; i < modes.size(); ++i) {
    modes[i].loss_factor = loss_factor[std::min(i, loss_factor.size() - 1)];
  }
  return model.with_modes(std::move(modes));
}

std::vector<StructuralJoint> joints_of(const StructureFile& file, const StructureModes& modes) {
  std::vector<StructuralJoint> joints;
  for (std::size_t j = 0; j < file.sources.size(); ++j) {
    const JointSource& source = file.sources[j];
    const bool stuck = file.joints == JointsInModes::kStuck;
    joints.push_back({.name = file.structure.joints[j].name,
                      .joint = source.joint,
                      .shape = modes.joint_shapes[j],
                      .spring_in_modes = stuck ? source.joint.stiffness() : 0.0,
                      .linear_damping = source.linear_damping});
  }
  return joints;
}

/// Number of modes that represent those left out, where it is known.
std::optional<std::size_t> attachments_of(const StructureFile& file, const StructureModes& modes) {
  if (file.test) return std::nullopt;
  const std::size_t attached = modes.model.size() - modes.modes;
  const bool whole = modes.modes == modes.degrees_of_freedom;
  if (attached > 0 || file.attachment || whole) return attached;
  return std::nullopt;
}

/// The largest share of a mode's strain energy that springs across joints hold, and which mode.
std::pair<double, std::size_t> most_in_springs(const StructureFile& file,
                                               const StructureModes& modes) {
  std::pair<double, std::size_t> most{0.0, 0};
  for (std::size_t i = modes.rigid_bodies; i < modes.modes; ++i) {
    const double omega = modes.model.modes()[i].angular_frequency;
    double share = 0.0;
    for (std::size_t j = 0; j < file.sources.size(); ++j) {
      const double over = modes.joint_shapes[j][i] / omega;
      share += file.sources[j].joint.stiffness() * over * over;
    }
    most = std::max(most, {share, i});
  }
  return most;
}

/// One loss factor for all is that of a material, which springs across joints have no part in.
void warn_of_damped_springs(const StructureFile& file, StructureModes& modes) {
  if (file.joints != JointsInModes::kStuck) return;
  if (file.loss_factor.size() > 1 || file.loss_factor.front() == 0.0) return;
  const auto [share, mode] = most_in_springs(file, modes);
  if (share < kSharedSprings) return;
  modes.warnings.push_back(
      {"springs_damped",
       fmt::format("with one loss factor for all stuck modes the springs of the joints, which have "
                   "{:.2g} % of the strain energy of mode {}, are damped as the rest, in addition "
                   "to the slip of the joints. Take joints = \"free\" for the loss factor of a "
                   "material, or one per mode as measured with the joints stuck.",
                   100.0 * share, mode + 1)});
}

std::string attachment_text(const StructureModes& modes) {
  const std::size_t attached = modes.model.size() - modes.modes;
  if (attached == 0) return {};
  return fmt::format(
      "\nOf {} modes those from number {} on are static attachments, no vibrations of the "
      "structure: "
      "with them joints\nand excited points have the static compliance of the matrices.",
      modes.model.size(), modes.modes + 1);
}

std::string damping_text(const Mode& mode, DampingLaw law) {
  return law == DampingLaw::kViscous ? fmt::format("damping ratio {:.4g}", 0.5 * mode.loss_factor)
                                     : fmt::format("loss factor {:.4g}", mode.loss_factor);
}

/// Origin of a model from a test, for its reader.
std::vector<std::string> origin_of(const TestedStructureModes& tested, bool damping_given) {
  std::vector<std::string> text = tested.origin;
  for (std::size_t i = 0; i < tested.lines.size(); ++i) {
    const Mode& mode = tested.modes.model.modes()[i];
    text.push_back(fmt::format(
        "mode {}: {:.6f} Hz, {}, {}", i + 1, in_hertz(mode.angular_frequency),
        damping_given ? "damping as given" : damping_text(mode, tested.law), tested.lines[i]));
  }
  return text;
}

std::string comment_of(const std::string& path, const std::string& command,
                       const StructureModes& modes, const std::vector<std::string>& origin) {
  std::string text = heading_of(command);
  text += fmt::format("\n{}: {} degrees of freedom, {}", path, modes.degrees_of_freedom,
                      modes.joints == JointsInModes::kStuck ? "joints stuck" : "joints free");
  for (const std::string& line : origin) text += "\n" + line;
  return text + attachment_text(modes);
}

std::string compliance_lines(const StructureModes& modes) {
  std::string text;
  for (const StaticCompliance& one : modes.compliances) {
    const auto share = [&](double part) {
      return one.exact > 0.0 ? 100.0 * part / one.exact : 0.0;
    };
    text +=
        fmt::format("  {} '{}': static {:.4g} {}, in the modes {:.4g} %, in the model {:.6g} %\n",
                    to_string(one.place), one.name, one.exact, unit_of(one), share(one.in_modes),
                    share(one.in_model));
  }
  return text;
}

}  // namespace

StructureModel model_of_structure(const std::string& path, const std::string& out,
                                  const std::string& command, const Progress& progress) {
  StructureFile file = read_structure_file(path);
  std::optional<TestedStructureModes> tested;
  if (file.test) tested = modes_of_test(file);
  const bool damping_given = !file.loss_factor.empty();
  if (tested && !damping_given) file.law = tested->law;
  std::vector<std::string> origin;
  if (tested) origin = origin_of(*tested, damping_given);
  StructureModes modes = tested
                             ? std::move(tested->modes)
                             : compute_structure_modes(file.structure, options_of(file, progress));
  if (!tested) warn_of_damped_springs(file, modes);
  modes.warnings.insert(modes.warnings.begin(), file.warnings.begin(), file.warnings.end());
  std::vector<StructuralJoint> joints = joints_of(file, modes);
  std::vector<JointSource> sources = std::move(file.sources);
  for (JointSource& source : sources) {
    if (!source.file.empty()) source.file = path_from(source.file, out);
    if (!source.samples.empty()) source.samples = path_from(source.samples, out);
  }
  ModelFile model = make_model(damped(modes.model, file.loss_factor), file.law, std::move(joints),
                               std::move(sources), std::move(file.driven));
  model.static_attachments = attachments_of(file, modes);
  std::string text = format_model(
      model, with_warnings(comment_of(input_name(path), command, modes, origin), modes.warnings));
  return {std::move(model), std::move(modes), std::move(text), std::move(origin)};
}

std::string describe_structure_model(const std::string& path, const StructureModel& model) {
  const StructureModes& modes = model.modes;
  std::string text = fmt::format(
      "{}: {} degrees of freedom, {} modes{}, {}\n", path, modes.degrees_of_freedom, modes.modes,
      modes.model.size() > modes.modes
          ? fmt::format(" and {} static attachment{}", modes.model.size() - modes.modes,
                        modes.model.size() - modes.modes == 1 ? "" : "s")
          : "",
      modes.joints == JointsInModes::kStuck ? "joints stuck" : "joints free");
  for (const std::string& line : model.origin) text += fmt::format("  {}\n", line);
  if (!model.origin.empty()) return text + fmt::format("  {}\n", modes.summary.brief());
  for (std::size_t i = 0; i < std::min(modes.modes, kModesShown); ++i) {
    text += fmt::format("  mode {:<3} {:>14.6f} Hz\n", i + 1,
                        in_hertz(modes.model.modes()[i].angular_frequency));
  }
  if (modes.modes > kModesShown) {
    text += fmt::format("  … mode {} {:.6f} Hz\n", modes.modes,
                        in_hertz(modes.model.modes()[modes.modes - 1].angular_frequency));
  }
  if (modes.rigid_bodies > 0) {
    text += fmt::format(
        "  {} of them rigid-body modes, without stiffness: below {:.2g} Hz, the "
        "rounding of the matrix\n",
        modes.rigid_bodies, in_hertz(std::sqrt(modes.rounding)));
  }
  text += compliance_lines(modes);
  for (const BaseMass& base : modes.base_masses) {
    text += fmt::format("  base '{}': the modes move {:.4g} % of its {:.6g} kg\n", base.name,
                        100.0 * base.in_modes / base.total, base.total);
  }
  return text + fmt::format("  {}\n", modes.summary.brief());
}

}  // namespace microslip
