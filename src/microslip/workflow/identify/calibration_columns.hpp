// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/workflow/identify/calibration_results.hpp"

/// @file
/// Columns of calibration.csv and identifiability.csv, for writer and reader. Internal to workflow.

namespace microslip {

/// A column, by the member that holds it.
template <typename Record>
struct ResultColumn {
  std::string_view name;  ///< without unit; of a joint what stands before the name of that
  Dimension dimension;    ///< of its values, in SI
  std::vector<double> Record::*values;
  bool needed = false;  ///< whether a table without it is refused
};

/// What stands before the names of measured quantities.
inline constexpr std::string_view kMeasured = "measured_";

/// calibration.csv, behind `level`, `mode` and `displacement`.
inline constexpr std::array kLevelColumns{
    ResultColumn<LevelsOfModes>{"measured_frequency", kFrequency,
                                &LevelsOfModes::measured_frequency},
    ResultColumn<LevelsOfModes>{"measured_frequency_std", kFrequency,
                                &LevelsOfModes::measured_frequency_std},
    ResultColumn<LevelsOfModes>{"frequency", kFrequency, &LevelsOfModes::frequency, true},
    ResultColumn<LevelsOfModes>{"frequency_residual", kDimensionless,
                                &LevelsOfModes::frequency_residual},
    ResultColumn<LevelsOfModes>{"measured_dissipation", kEnergy,
                                &LevelsOfModes::measured_dissipation},
    ResultColumn<LevelsOfModes>{"measured_dissipation_std", kEnergy,
                                &LevelsOfModes::measured_dissipation_std},
    ResultColumn<LevelsOfModes>{"dissipation", kEnergy, &LevelsOfModes::dissipation, true},
    ResultColumn<LevelsOfModes>{"residual", kDimensionless, &LevelsOfModes::residual},
    ResultColumn<LevelsOfModes>{"measured_damping_ratio", kDimensionless,
                                &LevelsOfModes::measured_damping_ratio},
    ResultColumn<LevelsOfModes>{"measured_damping_ratio_std", kDimensionless,
                                &LevelsOfModes::measured_damping_ratio_std},
    ResultColumn<LevelsOfModes>{"damping_ratio", kDimensionless, &LevelsOfModes::damping_ratio,
                                true},
};

/// Behind these, of each joint.
inline constexpr std::array kJointColumns{
    ResultColumn<JointOverLevels>{"amplitude_", kLength, &JointOverLevels::amplitude},
    ResultColumn<JointOverLevels>{"measured_amplitude_", kLength,
                                  &JointOverLevels::measured_amplitude},
    ResultColumn<JointOverLevels>{"dissipation_", kEnergy, &JointOverLevels::dissipation},
    ResultColumn<JointOverLevels>{"dissipation_lower_", kEnergy,
                                  &JointOverLevels::dissipation_lower},
    ResultColumn<JointOverLevels>{"dissipation_upper_", kEnergy,
                                  &JointOverLevels::dissipation_upper},
};

/// identifiability.csv, behind `joint`. Of densities of assemblies those that are needed.
inline constexpr std::array kDensityColumns{
    ResultColumn<DensityFound>{"slip_force", kForce, &DensityFound::slip_force, true},
    ResultColumn<DensityFound>{"slip_displacement", kLength, &DensityFound::slip_displacement},
    ResultColumn<DensityFound>{"density", kPerForce, &DensityFound::density, true},
    ResultColumn<DensityFound>{"lower", kPerForce, &DensityFound::lower, true},
    ResultColumn<DensityFound>{"upper", kPerForce, &DensityFound::upper, true},
    ResultColumn<DensityFound>{"told", kDimensionless, &DensityFound::variance_reduction},
};

}  // namespace microslip
