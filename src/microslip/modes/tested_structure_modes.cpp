// SPDX-License-Identifier: MIT
#include "microslip/modes/tested_structure_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/modes/place_motion.hpp"
#include "microslip/modes/tested_modes.hpp"
#include "microslip/structure/static_compliance.hpp"

namespace microslip {
namespace {

/// Rounding of k Σψ²/ω² with the joint stuck, which is 1 for a structure restrained only by the
/// joint.
constexpr double kRoundingOfShare = 1e-6;

/// Leaves out what lies above; the lowest are kept.
void keep_up_to(double hertz, TestedModes& tested) {
  const double highest = 2.0 * std::numbers::pi * hertz;
  const auto above = std::ranges::find_if(
      tested.modes, [&](const Mode& mode) { return mode.angular_frequency > highest; });
  const auto count = static_cast<std::size_t>(above - tested.modes.begin());
  if (count == 0) {
    throw InputError("modes.up_to_Hz", hertz,
                     fmt::format("must be above the first mode of the test, {:.6g} Hz",
                                 tested.modes.front().angular_frequency / 2.0 / std::numbers::pi));
  }
  tested.modes.resize(count);
  tested.lines.resize(count);
  tested.shapes.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(count));
}

std::vector<double> motion_of(const TestedModes& tested, const Motion& motion,
                              const std::string& place) {
  Eigen::RowVectorXd shape = Eigen::RowVectorXd::Zero(tested.shapes.cols());
  for (const auto& [row, weight] : motion) {
    shape += weight * tested.shapes.row(static_cast<Eigen::Index>(row));
  }
  if (shape.norm() > 0.0) return {shape.begin(), shape.end()};
  throw InputError(place, "0 in all modes of the test", "must move",
                   "Was this direction measured? Check its places and its direction.");
}

/// The measured freedoms in place of the rows of matrices.
MeshedStructure measured(const MeshedStructure& structure, const TestedModes& tested) {
  MeshedStructure rows{.matrices = {}, .nodes = structure.nodes};
  rows.matrices.degrees = tested.freedoms;
  rows.matrices.stiffness.size = tested.freedoms.size();
  return rows;
}

void check_stuck(const MeshJoint& joint, double compliance) {
  if (joint.stiffness * compliance <= 1.0 + kRoundingOfShare) return;
  throw InputError(
      fmt::format("stiffness of joint '{}'", joint.name), joint.stiffness,
      fmt::format("must be below {:.4g}: with the joint stuck the modes have {:.4g} m/N across "
                  "it, more than its own spring alone",
                  1.0 / compliance, compliance),
      "Is k too large, the scale of the shapes off, or was the joint free?");
}

void warn_of_missing_modes(const MeshJoint& joint, JointsInModes state, double compliance,
                           std::vector<Warning>& warnings) {
  const bool stuck = state == JointsInModes::kStuck;
  if (stuck) check_stuck(joint, compliance);
  warnings.push_back(
      {"no_attachment",
       fmt::format(
           "a test has no matrices, so that joint '{}' has only the modes of the test: the "
           "compliance of all others is missing. They have {:.4g} m/N across it with the joint "
           "{}, "
           "its spring 1/k = {:.4g} m/N. Its motion and its loss are predicted too small; {}. Take "
           "more modes, or matrices.",
           joint.name, compliance, stuck ? "stuck" : "free", 1.0 / joint.stiffness,
           stuck ? "at small amplitudes the frequencies are those of the test"
                 : "frequencies with it are predicted too high")});
}

}  // namespace

TestedStructureModes modes_of_test(const StructureFile& file) {
  const TestedStructure& test = *file.test;
  const TestedModesOptions options{.count = file.count, .damping_given = !file.loss_factor.empty()};
  TestedModes tested =
      test.shapes.empty() ? modes_of_responses(test, options) : modes_of_shapes(test, options);
  if (file.highest_frequency) keep_up_to(*file.highest_frequency, tested);

  const MeshedStructure structure = measured(file.structure, tested);
  const MeshRows rows(structure, RowsOf::kTest);
  std::vector<ModalPoint> points;
  for (const MeshPoint& point : file.structure.points) {
    points.push_back({.name = point.name,
                      .shape = motion_of(tested, place_motion(rows, point.place, point.direction),
                                         point.place.name)});
  }
  StructureModes modes{.model = {tested.modes, std::move(points)}};
  modes.joints = file.joints;
  modes.modes = tested.modes.size();
  modes.degrees_of_freedom = tested.freedoms.size();
  modes.rigid_bodies = static_cast<std::size_t>(std::ranges::count(
      tested.modes, 0.0, [](const Mode& mode) { return mode.angular_frequency; }));
  modes.warnings = test.warnings;
  modes.warnings.insert(modes.warnings.end(), tested.warnings.begin(), tested.warnings.end());
  for (const MeshJoint& joint : file.structure.joints) {
    modes.joint_shapes.push_back(motion_of(tested, joint_motion(rows, joint), joint.to.name));
    const double compliance = static_compliance(tested.modes, modes.joint_shapes.back());
    warn_of_missing_modes(joint, file.joints, compliance, modes.warnings);
  }
  modes.summary = std::move(tested.summary);
  if (!modes.summary.converged()) {
    modes.warnings.push_back({"modes_doubtful", modes.summary.reason + "."});
  }
  return {std::move(modes), tested.law, std::move(tested.origin), std::move(tested.lines)};
}

}  // namespace microslip
