// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"

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
/// and `told` may be empty.
struct DensityFound {
  std::string name = {};                ///< of the joint
  std::vector<double> slip_force = {};  ///< f*, N; rising
  std::vector<double> density = {};     ///< φ, 1/N
  std::vector<double> lower = {};       ///< of its band, 1/N
  std::vector<double> upper = {};       ///< of its band, 1/N
  std::vector<double> told = {};        ///< variance reduction, share of the prior's, 1
  double confidence = 0.95;             ///< of the band, 1
};

/// Results of a calibration for a joint.
struct JointSummary {
  std::string name = {};            ///< in the model
  double stiffness = 0.0;           ///< k, N/m
  double stiffness_lower = 0.0;     ///< of its band, N/m
  double stiffness_upper = 0.0;     ///< of its band, N/m
  double slipping_share = 0.0;      ///< of k that slips, 1
  double degrees_of_freedom = 0.0;  ///< that its density was worth
  double covered_from = 0.0;        ///< kA of the lowest level, N
  double covered_to = 0.0;          ///< kA of the highest, N
};

/// Results for two joints, see JointPair of calibrate().
struct PairSummary {
  std::string first = {};            ///< name of a joint
  std::string second = {};           ///< of another
  double correlation = 0.0;          ///< of their losses, 1
  double spread_alone = 0.0;         ///< of the better known, relative
  double spread_together = 0.0;      ///< of the sum, relative
  bool known_only_together = false;  ///< whether the sum alone is to be believed
};

/// The frequencies of a mode.
struct ModeOffset {
  std::size_t mode = 0;  ///< from 1
  double offset = 0.0;   ///< measured over found, less 1, the mean of its levels
};

/// Contents of calibration.json.
struct CalibrationSummary {
  std::string status = {};                     ///< "converged"
  double levels = 0.0;                         ///< that were given
  double levels_found = 0.0;                   ///< whose resonance was found
  double confidence = 0.0;                     ///< of the bands
  double scatter = 0.0;                        ///< of the losses
  bool scatter_is_relative = true;             ///< to them; else over their deviations
  double frequency_scatter = 0.0;              ///< of the frequencies; 0 without
  bool frequency_scatter_is_relative = true;   ///< to them; else over their deviations
  std::string frequency_use = {};              ///< "change", "absolute", "ignore"
  std::vector<JointSummary> joints = {};       ///< those found
  std::vector<ModeOffset> offsets = {};        ///< of modes with frequencies
  std::vector<PairSummary> pairs = {};         ///< every two joints found
  std::vector<std::string> known_in_sum = {};  ///< three joints and more
  std::vector<Warning> warnings = {};          ///< that it gave
};

}  // namespace microslip
