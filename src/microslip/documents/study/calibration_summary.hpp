// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/calibration_file.hpp"

/// @file
/// The results of a calibration as calibration.json holds them. All values are SI.

namespace microslip {

/// Results of a calibration for a joint.
struct JointSummary {
  std::string name = {};            ///< in the model
  double stiffness = 0.0;           ///< k, N/m
  double stiffness_lower = 0.0;     ///< of its band, N/m
  double stiffness_upper = 0.0;     ///< of its band, N/m
  double slipping_share = 0.0;      ///< of k that slips, 1
  double degrees_of_freedom = 0.0;  ///< that its density was worth
  double loss_significance = 0.0;   ///< largest variance reduction of its D by a level, 1
  double edges_evidence = 0.0;      ///< for edges of its density, ln of the odds
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

/// A jump of the density of a joint.
struct EdgeSummary {
  std::string joint = {};   ///< its name
  double slip_force = 0.0;  ///< at which it is, N
  double deviation = 0.0;   ///< its standard deviation, N
};

/// The frequencies of a mode.
struct ModeOffset {
  std::size_t mode = 0;  ///< from 0
  double offset = 0.0;   ///< measured over found, less 1, the mean of its levels
};

/// Results of calibrate() that belong to no single level or slip force.
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
  bool edges_sought = false;                   ///< whether densities may jump
  std::vector<EdgeSummary> edges = {};         ///< those found
  std::vector<ModeOffset> offsets = {};        ///< of modes with frequencies
  std::vector<PairSummary> pairs = {};         ///< every two joints found
  std::vector<std::string> known_in_sum = {};  ///< three joints and more
  std::vector<Warning> warnings = {};          ///< that it gave
};

/// The contents of the calibration.json of a calibration.
/// @param found  without `frequency_use`, which is one of the options of the provenance.
/// @param provenance  of the calibration.
[[nodiscard]] CalibrationFile calibration_file_of(CalibrationSummary found, Provenance provenance);

/// What calibration_file_of() wrote.
/// @param file  that was read.
/// @param path  of the file, for messages.
/// @throws InputError  naming a key that is missing, or a list of another length than those that it
///                     belongs to.
[[nodiscard]] CalibrationSummary calibration_summary_of(const CalibrationFile& file,
                                                        const std::string& path);

}  // namespace microslip
