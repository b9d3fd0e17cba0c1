// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// @file
/// Results of a calibration: joints that were identified from levels of modes. All values are SI.

namespace microslip {

/// A joint over the levels of modes. Each vector is empty or has one entry per level.
struct JointOverLevels {
  std::string name = {};                          ///< in the model
  std::vector<double> amplitude = {};             ///< as found, m
  std::vector<double> measured_amplitude = {};    ///< by a sensor, m
  std::vector<double> measured_dissipation = {};  ///< of this joint alone, J
  std::vector<double> dissipation = {};           ///< as found, J
  std::vector<double> dissipation_lower = {};     ///< end of its band, J
  std::vector<double> dissipation_upper = {};     ///< the other end, J
};

/// Levels of modes, measured and where known found. `mode` and `displacement` have one entry per
/// level, each other vector as many or none.
struct LevelsOfModes {
  std::vector<std::size_t> level = {};                  ///< in the file, from 1; may be empty
  std::vector<std::size_t> mode = {};                   ///< from 1
  std::vector<double> displacement = {};                ///< at the response point, m
  std::vector<double> measured_frequency = {};          ///< Hz
  std::vector<double> measured_frequency_std = {};      ///< Hz
  std::vector<double> frequency = {};                   ///< as found, Hz
  std::vector<double> frequency_residual = {};          ///< over its scatter, 1
  std::vector<double> measured_dissipation = {};        ///< of all joints together, J
  std::vector<double> measured_dissipation_std = {};    ///< J
  std::vector<double> dissipation = {};                 ///< as found, J
  std::vector<double> residual = {};                    ///< of the dissipation, over its scatter, 1
  std::vector<double> measured_damping_ratio = {};      ///< structure included, 1
  std::vector<double> measured_damping_ratio_std = {};  ///< 1
  std::vector<double> damping_ratio = {};               ///< as found, 1
  std::vector<JointOverLevels> joints = {};             ///< those of which there is a column
};

/// The density of a joint, and its variance reduction by the levels. Vectors of one length; band
/// and `variance_reduction` may be empty.
struct DensityFound {
  std::string name = {};                        ///< of the joint
  std::vector<double> slip_force = {};          ///< f*, N; rising
  std::vector<double> slip_displacement = {};   ///< x* = f*/k, m; may be empty
  std::vector<double> density = {};             ///< φ, 1/N
  std::vector<double> lower = {};               ///< of its band, 1/N
  std::vector<double> upper = {};               ///< of its band, 1/N
  std::vector<double> variance_reduction = {};  ///< variance reduction, share of the prior's, 1
  double confidence = 0.95;                     ///< of the band, 1
};

}  // namespace microslip
