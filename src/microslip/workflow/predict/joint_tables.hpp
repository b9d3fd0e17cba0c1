// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/path_file.hpp"
#include "microslip/dynamics/draws/drawn_joints.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// Tables of a single joint.

namespace microslip {

/// A table and what is to be known of it.
struct JointTable {
  std::string text;                      ///< CSV
  std::vector<Warning> warnings;         ///< also in the text
  std::optional<DrawsTaken> taken = {};  ///< what became of the draws, where there are
};

/// Uncertainty of a single joint.
struct JointUncertainty {
  std::string samples = {};  ///< path of its draws, joint_samples.h5; empty: none
  double normal_load = 0.0;  ///< σ of the factor of its slip forces, 1
};

/// A joint as it may be, and how often it is to be drawn.
struct LoneJointDraws {
  DrawnJoints joint;                           ///< draws of it
  DrawOptions options;                         ///< which of them
  std::string uncertain;                       ///< in words
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< reports the number done; may cancel
};

/// Reads the samples.
/// @param file       of the joint.
/// @param uncertain  something at least.
/// @param options    which draws.
/// @throws FileError, FormatError, InputError  as samples_for(), DrawnJoints and
///     DrawOptions::check(); where nothing is uncertain.
[[nodiscard]] LoneJointDraws draws_of(const JointFile& file, const JointUncertainty& uncertain,
                                      const DrawOptions& options);

/// The same of draws that are handed on one by one and make no band: of any number.
[[nodiscard]] LoneJointDraws draws_without_band(const JointFile& file,
                                                const JointUncertainty& uncertain,
                                                const DrawOptions& options);

/// `linear_damping_left_out`: a loss of βA² whatever the frequency is known for harmonics alone,
/// and is no force along a path. Nothing where the joint has none.
/// @param file  of the joint.
[[nodiscard]] std::optional<Warning> linear_damping_warning(const JointFile& file);

/// First loading from 0 to A, then one steady cycle: A to −A and back; m.
/// @param amplitude  A, m. @param points  of a branch; 1 or more.
[[nodiscard]] std::vector<double> loading_and_cycle(double amplitude, std::size_t points);

/// The force along a path, exact where the normal load is constant.
/// @param file      of the joint.
/// @param path      of the displacement.
/// @param law       of a normal load that varies.
/// @param elements  Jenkins elements of the joint then.
/// @param command   of the first comment, see heading_of(); empty: the table has none.
/// @param draws     of the joint; with them columns `lower`, `upper` of the force, point by point.
/// @throws InputError  as DrawOptions::check_size(), and where all draws failed.
/// @throws Cancelled   as the progress of the draws says.
[[nodiscard]] JointTable loop_of(const JointFile& file, const DisplacementPath& path,
                                 NormalLoadLaw law, std::size_t elements,
                                 const std::string& command,
                                 const std::optional<LoneJointDraws>& draws = {});

/// Virgin force, D + βA², k_eq and the loss factor of both over the amplitude, as levels have them.
/// @param file       of the joint, with β where one was identified.
/// @param amplitude  A, m; rising, from 0.
/// @param command    as of loop_of().
/// @param draws      of the joint; with them columns NAME_lower, NAME_upper of each. A draw that
///                   has a linear damping of its own has that one.
/// @throws InputError, Cancelled  as loop_of().
[[nodiscard]] JointTable dissipation_of(const JointFile& file, const std::vector<double>& amplitude,
                                        const std::string& command,
                                        const std::optional<LoneJointDraws>& draws = {});

}  // namespace microslip
