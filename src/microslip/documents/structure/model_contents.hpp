// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/rig/setup/point_sensor.hpp"

/// @file
/// Contents of a model.toml; model_file.hpp specifies the format.

namespace microslip {

/// Contents of a model.toml.
struct ModelFile {
  JointedStructure structure;            ///< with its joints and excitations
  std::string response;                  ///< the point where the response is measured
  std::vector<std::string> joint_files;  ///< one per joint, as they were opened
  /// covered_to() of each joint's file, N; fewer where they are not known.
  std::vector<std::optional<double>> covered_to = {};
  /// identified_damping() of each joint's file, J/m²; fewer where they are not known. What the
  /// model uses is linear_damping of its joints.
  std::vector<std::optional<double>> identified_damping = {};
  /// Indices of the joints that have a stiffness and no file, rising: springs that do not slip
  /// stand in for them, and their joint_files are empty.
  std::vector<std::size_t> to_find = {};
  /// Files of the draws of each joint, empty where it has none; fewer where they are not known.
  std::vector<std::string> joint_samples = {};
  /// Whether the model itself gives the linear damping of each joint; fewer: it does not.
  std::vector<bool> damping_said = {};
  StructureSpread spread = {};  ///< of its numbers
  /// How many of its modes, the last, stand for the static flexibility of those that are left out,
  /// those of a residual among them; 0 where none is left out, nothing where that is not given.
  std::optional<std::size_t> static_attachments = {};
  /// Of recordings: the channel of the force of each excitation, empty where it is not given.
  std::vector<std::string> force_channels = {};
  std::vector<PointSensor> accelerometers = {};  ///< of recordings; predictions do not use them
};

/// Whether a model may contain joints still to be identified.
enum class JointsToFind {
  kRefused,  ///< a prediction needs them
  kAllowed,  ///< for their identification
};

}  // namespace microslip
