// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/path_file.hpp"
#include "microslip/joint/jenkins_network.hpp"

/// @file
/// What a joint does by itself, as tables.

namespace microslip {

/// A table and what is to be known of it.
struct JointTable {
  std::string text;               ///< CSV
  std::vector<Warning> warnings;  ///< also in the text
};

/// First loading from 0 to A, then one steady cycle: A to −A and back; m.
/// @param amplitude  A, m. @param points  of a branch; 1 or more.
[[nodiscard]] std::vector<double> loading_and_cycle(double amplitude, std::size_t points);

/// The force along a path, exact where the normal load is constant.
/// @param file      of the joint.
/// @param path      of the displacement.
/// @param law       of a normal load that varies.
/// @param elements  Jenkins elements of the joint then.
[[nodiscard]] JointTable loop_of(const JointFile& file, const DisplacementPath& path,
                                 NormalLoadLaw law, std::size_t elements);

/// Virgin force, D + βA², k_eq and the loss factor of both over the amplitude, as levels have them.
/// @param file       of the joint, with β where one was identified.
/// @param amplitude  A, m; rising, from 0.
[[nodiscard]] JointTable dissipation_of(const JointFile& file,
                                        const std::vector<double>& amplitude);

}  // namespace microslip
