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

/// Options of modes_of_structure().
struct ModesOptions {
  std::optional<std::size_t> count = {};         ///< so many, or
  std::optional<double> highest_frequency = {};  ///< all up to this, Hz; one of both must be given
  JointsInModes joints = JointsInModes::kFree;   ///< while modes are computed
  /// Whether to add static shapes for the missing static displacement under a pair of forces at
  /// each joint, and under a force at each of `attached_points`, or an acceleration of it.
  bool attachment = true;
  std::vector<std::string> attached_points = {};  ///< names of points or bases
  Progress progress = {};  ///< called with the solutions done of their number; may stop it
};

/// Kinds of places with a static compliance.
enum class YieldingPlace : std::uint8_t { kJoint, kPoint, kBase };

/// "joint", "point", "base".
[[nodiscard]] std::string_view to_string(YieldingPlace place);

/// Static compliance of a place under a constant force, m/N, or about an axis under a constant
/// moment, rad/(N m); without rigid-body motion. Of a base that accelerates, rᵀM K⁻¹ M r, kg s².
struct StaticCompliance {
  std::string name;                             ///< of the joint, point or base
  bool turns = false;                           ///< about an axis
  YieldingPlace place = YieldingPlace::kJoint;  ///< what it is
  double exact = 0.0;       ///< of the matrices, of all their degrees of freedom
  double in_modes = 0.0;    ///< of the modes alone
  double in_model = 0.0;    ///< of modes and attachments
  double unbalanced = 0.0;  ///< share of the load that the displacement of `exact` leaves beyond
                            ///< rounding, 1
};

/// How much of the mass that a base moves the modes move.
struct BaseMass {
  std::string name;       ///< of the base
  double total = 0.0;     ///< rᵀ M r, kg
  double in_modes = 0.0;  ///< Σ Γ_i² of the modes alone: their effective mass, kg
};

/// A structure by its modes.
struct StructureModes {
  /// The modes, then the attachments; their loss factors are 0. Points as they were given.
  ModalModel model;
  /// ψ of each joint, kg^−½; one per mode and attachment.
  std::vector<std::vector<double>> joint_shapes = {};
  JointsInModes joints = JointsInModes::kFree;  ///< as asked
  std::size_t modes = 0;         ///< those of the structure; the rest are attachments
  std::size_t rigid_bodies = 0;  ///< number of modes with ω = 0: unrestrained
  double rounding = 0.0;  ///< ω² of a mode that rounding of K does not distinguish from a rigid
                          ///< body, rad²/s²; 0 without rigid bodies
  double doubtful = 0.0;  ///< ω² below which modes may be those of rigid bodies, or rigid bodies
                          ///< modes on soft springs, rad²/s²; 0 where there are none such
  std::vector<double> residuals = {};  ///< |(K − ω²M)φ| over |Kφ| + ω²|Mφ| of each mode, 1
  std::vector<StaticCompliance> compliances = {};  ///< of the joints, then of what is attached
  std::vector<BaseMass> base_masses = {};          ///< one per base
  std::size_t degrees_of_freedom = 0;  ///< degrees of freedom after supports and spiders
  std::vector<Warning> warnings = {};  ///< what the user must know
  Summary summary = {};                ///< of the search for modes
};

/// "m/N", "rad/(N m)" or, of a base, "kg s^2".
[[nodiscard]] std::string_view unit_of(const StaticCompliance& compliance);

/// From matrices to modes: find_natural_modes() and attach_statically() of assemble_system(). Each
/// takes MUMPS, which is called by one thread of the program at a time.
/// @throws InputError  as these three do. @throws Cancelled
[[nodiscard]] StructureModes compute_structure_modes(const MeshedStructure& structure,
                                                     const ModesOptions& options);

}  // namespace microslip
