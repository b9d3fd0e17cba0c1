// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"

/// @file
/// A virtual test from the file of its rig to the folder of its recordings.

namespace microslip {

/// Inputs and options of run_measurement().
struct MeasurementRun {
  std::string rig;              ///< path of rig.toml, with [test] and the true joint in [contact]
  std::string out;              ///< the folder; made where it is missing
  std::string format = "csv";   ///< of the records, see find_recording_format()
  std::uint64_t seed = 1;       ///< of noise and phases
  bool no_shaker = false;       ///< a pure force
  bool before_control = false;  ///< with the records under a sinusoidal voltage
  std::string command = {};     ///< that the files are made by
  Progress solving = {};        ///< reports the levels
  Progress writing = {};        ///< the same
};

/// Result of run_measurement().
struct FinishedMeasurement {
  std::string joint_path;            ///< of the true joint
  double linear_damping;             ///< β of it, J/m²
  VirtualMeasurement test;           ///< of which one level at least was found
  std::vector<std::string> records;  ///< names of the records of all levels
  std::vector<Warning> warnings;     ///< each kind once, as in the files
};

/// The file of the true joint of a virtual test, beside that of the rig.
/// @param rig       its contact. @param rig_path  of its file.
/// @throws InputError  where the rig names none.
[[nodiscard]] std::string true_joint_path(const Rig& rig, const std::string& rig_path);

/// Reads rig and joint, solves the test, and writes records, truth.csv, force_control.csv and
/// rig.toml into the folder: all or none.
/// @throws FileError, FormatError, InputError  as the readers and measure_virtually(), and where
///                                             the folder holds another test.
/// @throws NothingFound  where no level was found.
/// @throws Cancelled     as one of the progresses says.
[[nodiscard]] FinishedMeasurement run_measurement(const MeasurementRun& options);

/// The summary.
[[nodiscard]] std::string describe_measurement(const MeasurementRun& options,
                                               const FinishedMeasurement& done);

}  // namespace microslip
