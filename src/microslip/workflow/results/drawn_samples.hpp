// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/workflow/identify/calibration_results.hpp"

/// @file
/// Draws of a joint as curves.

namespace microslip {

/// Densities of draws over slip forces that all share.
struct SampledDensities {
  DensityFound found = {};                      ///< mean and 95 % band of all draws
  std::vector<std::vector<double>> drawn = {};  ///< φ of some draws, 1/N, spread over them
  std::vector<double> atom_slip_force = {};     ///< of the mean stiffness, N; empty without one
};

/// @param samples  as their check() demands. @param most  so many of them are drawn; ≥ 1.
[[nodiscard]] SampledDensities sampled_densities(const JointSamples& samples, std::size_t most);

}  // namespace microslip
