// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/workflow/identify/level_planning.hpp"

namespace microslip {

/// The highest peak of a structure's response, by draws of one of its joints.
struct PeakDraws {
  double frequency = 0.0;              ///< with the joint that was found, Hz
  double height = 0.0;                 ///< m, as above
  std::vector<Joint> joints;           ///< the draws that have it
  std::vector<double> heights;         ///< of each, m
  std::vector<Warning> warnings = {};  ///< of draws without it
};

/// All else of the structure is as its model says: what it does not know of itself no level of the
/// joint tells.
/// @param options  with the model, its joint, force and range of frequencies.
/// @param found    the joint as the levels tell it.
/// @param joints   draws of it.
/// @throws FileError, FormatError  as read_model(). @throws InputError  as plan_levels().
/// @throws Cancelled  as the progress says.
[[nodiscard]] PeakDraws peak_draws(const LevelPlanning& options, const Joint& found,
                                   std::span<const Joint> joints);

}  // namespace microslip
