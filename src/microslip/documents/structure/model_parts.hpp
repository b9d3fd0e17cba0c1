// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/structure/model_contents.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/setup/point_sensor.hpp"
#include "microslip/structure/modal_model.hpp"

/// @file
/// Parts of a model other than its modes: joints and their origin, excitations and measured points.

namespace microslip {

/// A joint, and where it comes from.
struct JointSource {
  std::string file;  ///< empty for a joint to be identified
  Joint joint;       ///< F(u); a spring of that stiffness for one that is to be found
  std::optional<double> covered_to;          ///< N
  std::optional<double> identified_damping;  ///< J/m²
  std::string samples = {};                  ///< file of its draws; empty without
  double normal_load_spread = 0.0;           ///< relative standard deviation
  double linear_damping = 0.0;               ///< β, J/m²: as given, else as identified
  bool damping_said = false;                 ///< β is given by the model, whatever was identified
};

/// Excitations of a structure, and its measured points.
struct DrivenPoints {
  std::vector<Excitation> excitations;      ///< at least one
  std::vector<std::string> channels;        ///< of their forces, empty where not given
  std::vector<double> gain_spreads;         ///< relative, of each force
  std::vector<StaticLoad> static_loads;     ///< may be none
  std::string response;                     ///< a point
  double response_gain_spread = 0.0;        ///< relative
  std::vector<PointSensor> accelerometers;  ///< of recordings
};

/// A model of its parts.
/// @param linear   its modes and points.
/// @param law      of the damping of the modes.
/// @param joints   how each sits in the structure.
/// @param sources  where each comes from; one per joint.
/// @param driven   by points of `linear`.
/// @param spread   of frequencies and loss factors; those of joints and gains are in the others.
/// @throws InputError  as JointedStructure.
[[nodiscard]] ModelFile make_model(ModalModel linear, DampingLaw law,
                                   std::vector<StructuralJoint> joints,
                                   std::vector<JointSource> sources, DrivenPoints driven,
                                   StructureSpread spread = {});

}  // namespace microslip
