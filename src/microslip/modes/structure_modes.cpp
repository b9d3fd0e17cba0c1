// SPDX-License-Identifier: MIT
#include "microslip/modes/structure_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/algebra/qr.hpp"
#include "microslip/base/error.hpp"
#include "microslip/modes/natural_modes.hpp"
#include "microslip/modes/static_attachment.hpp"
#include "microslip/modes/system_assembly.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

/// Missing share of a static compliance above which a warning is given.
constexpr double kLackAllowed = 0.01;
/// Share of a load that may be left unbalanced, or of a compliance that the modes may have beyond
/// it.
constexpr double kUnbalancedAllowed = 1e-6;
constexpr double kExcessAllowed = 1e-3;
/// ω² that rounding may hide, over that of the first mode that strains.
constexpr double kHiddenAllowed = 1e-4;
/// Hz: no structure with joints vibrates more slowly.
constexpr double kSlowestMode = 1e-3;
/// Motion of a joint in a rigid-body mode, relative to the largest: less is rounding.
constexpr double kHeldByJoint = 1e-6;

void add_springs(const MeshedStructure& structure, AssembledSystem& assembled) {
  assembled.system.spring_motions = assembled.joints;
  assembled.system.spring_stiffness = Eigen::VectorXd(assembled.joints.cols());
  for (std::size_t j = 0; j < structure.joints.size(); ++j) {
    const MeshJoint& joint = structure.joints[j];
    if (!(joint.stiffness > 0.0 && std::isfinite(joint.stiffness))) {
      throw InputError(fmt::format("stiffness of joint '{}'", joint.name), joint.stiffness,
                       "must be positive and finite");
    }
    assembled.system.spring_stiffness(static_cast<Index>(j)) = joint.stiffness;
  }
}

std::optional<std::size_t> base_index(const MeshedStructure& structure, const std::string& name) {
  const auto found = std::ranges::find(structure.bases, name, &MeshBase::name);
  if (found == structure.bases.end()) return std::nullopt;
  return static_cast<std::size_t>(found - structure.bases.begin());
}

std::size_t point_index(const MeshedStructure& structure, const std::string& name) {
  const auto found = std::ranges::find(structure.points, name, &MeshPoint::name);
  if (found != structure.points.end()) {
    return static_cast<std::size_t>(found - structure.points.begin());
  }
  std::string there;
  for (const MeshPoint& point : structure.points) {
    there += fmt::format("{}'{}'", there.empty() ? "" : ", ", point.name);
  }
  throw InputError("point", fmt::format("'{}'", name), "is not one of the structure",
                   fmt::format("Points there are: {}.", there.empty() ? "none" : there));
}

/// The loads of the attachments, with their places.
Sparse attached_loads(const MeshedStructure& structure, const AssembledSystem& assembled,
                      const ModesOptions& options, std::vector<StaticCompliance>& names) {
  std::vector<Eigen::SparseVector<double>> columns;
  for (std::size_t j = 0; j < structure.joints.size(); ++j) {
    const MeshJoint& joint = structure.joints[j];
    const bool turns = !joint.to.row && joint.direction.turns;
    names.push_back({.name = joint.name, .turns = turns});
    columns.emplace_back(assembled.joints.col(static_cast<Index>(j)));
  }
  for (const std::string& name : options.attached_points) {
    if (const auto base = base_index(structure, name)) {
      names.push_back({.name = name, .place = YieldingPlace::kBase});
      columns.emplace_back(assembled.base_loads.col(static_cast<Index>(*base)).sparseView());
      continue;
    }
    const std::size_t at = point_index(structure, name);
    const MeshPoint& point = structure.points[at];
    const bool turns = !point.place.row && point.direction.turns;
    names.push_back({.name = name, .turns = turns, .place = YieldingPlace::kPoint});
    columns.emplace_back(assembled.points.col(static_cast<Index>(at)));
  }
  Sparse loads(assembled.system.size(), static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    loads.col(static_cast<Index>(j)) = columns[j];
  }
  return loads;
}

std::vector<double> shape_of(const Eigen::MatrixXd& shapes, const Sparse& motions, Index column) {
  const Eigen::VectorXd shape = shapes.transpose() * Eigen::VectorXd(motions.col(column));
  return {shape.begin(), shape.end()};
}

ModalModel model_of(const MeshedStructure& structure, const AssembledSystem& assembled,
                    const Eigen::VectorXd& eigenvalues, const Eigen::MatrixXd& shapes,
                    std::size_t vibrations) {
  std::vector<Mode> modes;
  for (const double eigenvalue : eigenvalues)
    modes.push_back({.angular_frequency = std::sqrt(eigenvalue)});
  std::vector<ModalPoint> points;
  for (std::size_t i = 0; i < structure.points.size(); ++i) {
    points.push_back({.name = structure.points[i].name,
                      .shape = shape_of(shapes, assembled.points, static_cast<Index>(i))});
  }
  std::vector<ModalBase> bases;
  for (std::size_t b = 0; b < structure.bases.size(); ++b) {
    const auto column = static_cast<Index>(b);
    const Eigen::VectorXd participation = shapes.transpose() * assembled.base_loads.col(column);
    const Eigen::VectorXd motion = assembled.base_motions.col(column);
    bases.push_back({.name = structure.bases[b].name,
                     .participation = {participation.begin(), participation.end()},
                     .point_motion = {motion.begin(), motion.end()}});
  }
  const std::size_t attached = modes.size() - vibrations;
  return {std::move(modes), std::move(points), std::move(bases), attached};
}

/// Rows of a structure that is no coarse model.
constexpr std::size_t kManyRows = 20;

/// Of the mass that a base moves, in rows that it strains: more than beside supports.
constexpr double kStrainedMassAllowed = 0.25;

/// A structure that translates is strained beside its supports alone.
void warn_of_strained_base(const AssembledSystem& assembled, std::size_t b, StructureModes& found) {
  const AssembledSystem::MovedRows rows = assembled.base_rows[b];
  const bool many = 2 * rows.strained > rows.moved || rows.strained_mass > kStrainedMassAllowed;
  if (rows.moved < kManyRows || !many) return;
  found.warnings.push_back(
      {"base_rows_doubtful",
       fmt::format("Base '{}' strains {} of the {} rows that it moves, with {:.3g} % of the mass. "
                   "Are all of them translations, and is {:.6g} kg the mass that it carries? Inner "
                   "degrees of "
                   "freedom of elements, rotations and openings must not move with it: give the "
                   "nodes and elements by [nodes], or the rows that move.",
                   found.model.bases()[b].name, rows.strained, rows.moved,
                   100.0 * rows.strained_mass, assembled.base_masses(static_cast<Index>(b)))});
}

void report_base_masses(const AssembledSystem& assembled, StructureModes& found) {
  for (std::size_t b = 0; b < found.model.bases().size(); ++b) {
    const ModalBase& base = found.model.bases()[b];
    double moved = 0.0;
    for (std::size_t i = 0; i < found.modes; ++i)
      moved += base.participation[i] * base.participation[i];
    found.base_masses.push_back({base.name, assembled.base_masses(static_cast<Index>(b)), moved});
    warn_of_strained_base(assembled, b, found);
    if (!assembled.base_mass_missing[b]) continue;
    found.warnings.push_back(
        {"base_mass_missing",
         fmt::format("Supports of the matrices from outside are taken to move with base "
                     "'{}'. The element mass shared with fixed degrees of freedom is in no matrix: "
                     "the load of the base is too small by it. Fix the nodes by "
                     "[[support]] instead, and the load is exact.",
                     base.name)});
  }
}

/// How many of the motions of rigid bodies, those of modes without stiffness, move no joint.
std::size_t not_held_by_joints(const StructureModes& found) {
  const auto rigid = static_cast<Index>(found.rigid_bodies);
  if (found.joint_shapes.empty() || found.joints == JointsInModes::kStuck) {
    return found.rigid_bodies;
  }
  Eigen::MatrixXd moved(static_cast<Index>(found.joint_shapes.size()), rigid);
  for (Index j = 0; j < moved.rows(); ++j) {
    const std::vector<double>& shape = found.joint_shapes[static_cast<std::size_t>(j)];
    moved.row(j) = Eigen::Map<const Eigen::RowVectorXd>(shape.data(), rigid);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> rank(moved);
  rank.setThreshold(kHeldByJoint);
  return found.rigid_bodies - static_cast<std::size_t>(rank.rank());
}

double hertz_of(double square) { return std::sqrt(square) / (2.0 * std::numbers::pi); }

/// Springs may be lost in the digits of stiff ones: no support is missing then.
void warn_of_rigid_bodies(StructureModes& found) {
  if (found.rigid_bodies == 0) return;
  const std::size_t loose = not_held_by_joints(found);
  if (loose == 0) return;
  const double hidden = hertz_of(found.rounding);
  std::string cause = " Is a support missing?";
  if (found.doubtful > 0.0) {
    cause = " Springs may be lost in the digits of the stiffness matrix.";
  } else if (hidden >= kSlowestMode) {
    cause += fmt::format(
        " (Springs on which it is slower than {:.2g} Hz are lost in the digits of the matrix.)",
        hidden);
  }
  found.warnings.push_back(
      {"rigid_bodies", fmt::format("{} mode{} of 0 Hz {} restrained by nothing{}.{}", loose,
                                   loose == 1 ? "" : "s", loose == 1 ? "is" : "are",
                                   found.joint_shapes.empty() ? "" : ", no joint either", cause)});
}

/// ω of the first mode above what the digits hide, rad/s; 0 without one.
double first_above(const StructureModes& found, double hidden) {
  for (std::size_t i = found.rigid_bodies; i < found.modes; ++i) {
    const double omega = found.model.modes()[i].angular_frequency;
    if (omega * omega > hidden) return omega;
  }
  return 0.0;
}

void warn_of_rounding(StructureModes& found) {
  const double hidden = std::max(found.rounding, found.doubtful);
  const double first = first_above(found, hidden);
  const bool near = first > 0.0 && found.rounding > kHiddenAllowed * first * first;
  if (!near && found.doubtful == 0.0) return;
  found.warnings.push_back(
      {"rigid_bodies_doubtful",
       fmt::format("The digits of the stiffness matrix do not distinguish modes below {:.3g} Hz "
                   "from rigid-body modes{}. Soft springs may be lost, or rigid-body modes have a "
                   "frequency. Give the matrix with more digits, a coarser mesh or fewer stiff "
                   "springs.",
                   hertz_of(hidden),
                   first > 0.0 ? fmt::format("; the first mode above is at {:.4g} Hz",
                                             first / (2.0 * std::numbers::pi))
                               : "")});
}

std::string capitalised(YieldingPlace place) {
  std::string text(to_string(place));
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

void warn_of_statics(StructureModes& found) {
  for (const StaticCompliance& one : found.compliances) {
    if (one.unbalanced <= kUnbalancedAllowed &&
        one.in_modes <= (1.0 + kExcessAllowed) * one.exact) {
      continue;
    }
    found.warnings.push_back(
        {"static_doubtful",
         fmt::format("{} '{}': the static displacement leaves {:.2g} of the load unbalanced, its "
                     "compliance {:.4g} {} (in the modes {:.4g}) is doubtful. Are stiffnesses of "
                     "very different size in the matrix?",
                     capitalised(one.place), one.name, one.unbalanced, one.exact, unit_of(one),
                     one.in_modes)});
  }
}

void warn_of_lacks(bool attached, StructureModes& found) {
  for (const StaticCompliance& one : found.compliances) {
    const double lack = one.exact > 0.0 ? 1.0 - one.in_model / one.exact : 0.0;
    if (lack <= kLackAllowed) continue;
    found.warnings.push_back(
        {"compliance_lacks",
         fmt::format("{} '{}' has a compliance of {:.4g} {} under a constant {}, in the model "
                     "{:.3g} % less. {}",
                     capitalised(one.place), one.name, one.exact, unit_of(one),
                     one.place == YieldingPlace::kBase ? "acceleration" : "force", 100.0 * lack,
                     attached ? "The missing part moves without mass."
                              : "Take the attachments, or more modes.")});
  }
}

void warn_of_slow_modes(StructureModes& found) {
  const std::size_t first = found.rigid_bodies;
  if (first >= found.modes) return;
  const double hertz = found.model.modes()[first].angular_frequency / (2.0 * std::numbers::pi);
  if (hertz >= kSlowestMode) return;
  found.warnings.push_back(
      {"slow_modes", fmt::format("The first mode is at {:.3g} Hz, a period of {:.3g} s. Are the "
                                 "matrices exchanged, or in other units?",
                                 hertz, 1.0 / hertz)});
}

void warn_of_loose_rows(const AssembledSystem& assembled, StructureModes& found) {
  const AssembledSystem::LooseRows& loose = assembled.loose_rows;
  if (loose.count == 0) return;
  found.warnings.push_back(
      {"stiffness_rows_missing",
       fmt::format("The stiffness matrix has no entry at {} degree{} of freedom with mass, the "
                   "first of them {}, and no joint holds {}. Is its file truncated?",
                   loose.count, loose.count == 1 ? "" : "s", loose.first,
                   loose.count == 1 ? "it" : "them")});
}

void warn_of_search(StructureModes& found) {
  if (found.summary.converged()) return;
  found.warnings.push_back({"modes_doubtful", found.summary.reason + "."});
}

}  // namespace

std::string_view to_string(YieldingPlace place) {
  switch (place) {
    case YieldingPlace::kJoint:
      return "joint";
    case YieldingPlace::kPoint:
      return "point";
    case YieldingPlace::kBase:
      break;
  }
  return "base";
}

std::string_view unit_of(const StaticCompliance& compliance) {
  if (compliance.place == YieldingPlace::kBase) return "kg s^2";
  return compliance.turns ? "rad/(N m)" : "m/N";
}

StructureModes compute_structure_modes(const MeshedStructure& structure,
                                       const ModesOptions& options) {
  AssembledSystem assembled = assemble_system(structure);
  if (options.joints == JointsInModes::kStuck) add_springs(structure, assembled);
  std::vector<StaticCompliance> compliances;
  const Sparse loads = attached_loads(structure, assembled, options, compliances);
  const ModeRange range{.count = options.count, .highest_frequency = options.highest_frequency};
  const NaturalModes modes = find_natural_modes(assembled.system, range, options.progress);

  Eigen::VectorXd eigenvalues = modes.eigenvalues;
  Eigen::MatrixXd shapes = modes.shapes;
  if (loads.cols() > 0) {
    const StaticAttachment attachment = attach_statically(assembled.system, modes, loads);
    for (std::size_t j = 0; j < compliances.size(); ++j) {
      const auto column = static_cast<Index>(j);
      compliances[j].exact = attachment.compliance(column);
      compliances[j].in_modes = attachment.in_modes(column);
      compliances[j].unbalanced =
          std::max(attachment.residuals(column) - attachment.rounding(column), 0.0);
      compliances[j].in_model = options.attachment
                                    ? attachment.compliance(column) - attachment.massless(column)
                                    : attachment.in_modes(column);
    }
    if (options.attachment && attachment.eigenvalues.size() > 0) {
      const Index count = modes.eigenvalues.size();
      const Index further = attachment.eigenvalues.size();
      eigenvalues.conservativeResize(count + further);
      eigenvalues.tail(further) = attachment.eigenvalues;
      shapes.conservativeResize(Eigen::NoChange, count + further);
      shapes.rightCols(further) = attachment.shapes;
    }
  }

  StructureModes found{.model = model_of(structure, assembled, eigenvalues, shapes,
                                         static_cast<std::size_t>(modes.eigenvalues.size()))};
  for (std::size_t j = 0; j < structure.joints.size(); ++j) {
    found.joint_shapes.push_back(shape_of(shapes, assembled.joints, static_cast<Index>(j)));
  }
  found.joints = options.joints;
  found.modes = static_cast<std::size_t>(modes.eigenvalues.size());
  found.rigid_bodies = modes.rigid_bodies;
  found.rounding = modes.rounding;
  found.doubtful = modes.doubtful;
  found.residuals.assign(modes.residuals.begin(), modes.residuals.end());
  found.compliances = std::move(compliances);
  found.degrees_of_freedom = static_cast<std::size_t>(assembled.system.size());
  found.summary = modes.summary;
  report_base_masses(assembled, found);
  warn_of_loose_rows(assembled, found);
  warn_of_rigid_bodies(found);
  warn_of_rounding(found);
  warn_of_statics(found);
  warn_of_lacks(options.attachment, found);
  warn_of_slow_modes(found);
  warn_of_search(found);
  return found;
}

}  // namespace microslip
