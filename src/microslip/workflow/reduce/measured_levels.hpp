// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/io/output/provenance.hpp"
#include "microslip/observe/levels.hpp"

namespace microslip {

/// The levels of a test. Each vector but those of `levels` is empty or has one entry per level.
struct MeasuredLevels {
  Levels levels;                                 ///< that the others belong to
  std::vector<std::string> source = {};          ///< of the record
  std::vector<std::string> flags = {};           ///< with blanks between them
  std::vector<double> frequency = {};            ///< of the drive, Hz
  std::vector<double> resonance_frequency = {};  ///< Hz
  std::vector<double> force_amplitude = {};      ///< N
  std::vector<double> response_amplitude = {};   ///< m/s²
  std::vector<double> input_energy = {};         ///< J
  std::vector<double> linear_dissipation = {};   ///< J
  std::vector<double> force_distortion = {};     ///< 1
  std::vector<double> damping_ratio = {};        ///< of the mode, by a ring-down, 1
  std::vector<bool> left_out = {};               ///< of the identification: inner reversals
};

/// Those of levels.csv or truth.csv. @throws FormatError, InputError
[[nodiscard]] MeasuredLevels levels_of(const NamedInput& input);

}  // namespace microslip
