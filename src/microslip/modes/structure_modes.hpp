// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/structure/meshed_structure.hpp"
#include "microslip/structure/modal_model.hpp"

namespace microslip {

/// What modes are made of a structure.
struct ModesOptions {
  std::optional<std::size_t> count = {};         ///< so many, or
  std::optional<double> highest_frequency = {};  ///< all up to this, Hz; one of both must be given
  JointsInModes joints = JointsInModes::kFree;   ///< while modes are computed
  /// Shapes beside the modes that hold what is missing in the static displacement under a pair of
  /// forces at each joint, and under one at each of `attached_points`.
  bool attachment = true;
  std::vector<std::string> attached_points = {};  ///< names of points
  Progress progress = {};  ///< told what is done of some number of solutions; may stop it
};

/// How much a place gives way under a constant force, m/N, or about an axis under a constant moment,
/// rad/(N m); without the motion of rigid bodies.
struct StaticCompliance {
  std::string name;       ///< of the joint or point
  bool turns = false;     ///< about an axis
  bool is_joint = true;   ///< or a point
  double exact = 0.0;     ///< of the matrices, of all their degrees of freedom
  double in_modes = 0.0;  ///< of the modes alone
  double in_model = 0.0;  ///< of modes and attachments
};

/// A structure by its modes.
struct StructureModes {
  /// The modes, then the attachments; their loss factors are 0. Points as they were given.
  ModalModel model;
  /// ψ of each joint, kg^−½; one a mode and attachment.
  std::vector<std::vector<double>> joint_shapes = {};
  JointsInModes joints = JointsInModes::kFree;  ///< as asked
  std::size_t modes = 0;               ///< those of the structure; the rest are attachments
  std::size_t rigid_bodies = 0;        ///< so many modes have ω = 0: nothing holds them
  std::vector<double> residuals = {};  ///< |(K − ω²M)φ| over |Kφ| + ω²|Mφ| of each mode, 1
  std::vector<StaticCompliance> compliances = {};  ///< of the joints, then of the points attached
  std::size_t degrees_of_freedom = 0;  ///< that are left of the matrices by supports and spiders
  std::vector<Warning> warnings = {};  ///< what the user must know
  Summary summary = {};                ///< of the search for modes
};

/// "m/N" or "rad/(N m)".
[[nodiscard]] std::string_view unit_of(const StaticCompliance& compliance);

/// From matrices to modes: find_natural_modes() and attach_statically() of assemble_system(). Each
/// takes MUMPS, which is called by one thread of the program at a time.
/// @throws InputError  as these three do. @throws Cancelled
[[nodiscard]] StructureModes compute_structure_modes(const MeshedStructure& structure,
                                                     const ModesOptions& options);

}  // namespace microslip
