// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/joint/identified_joint.hpp"
#include "microslip/documents/study/calibration_summary.hpp"
#include "microslip/identify/assemblies/assemblies.hpp"
#include "microslip/identify/methods/identification.hpp"

/// @file
/// Results of identifications as joint.json and calibration.json hold them. Internal to workflow.

namespace microslip {

/// Of levels, of records, or of both; without the sources of records.
[[nodiscard]] IdentifiedJoint found_joint(const Identification& found);

/// The mean of the assemblies: spreads, assumptions, warnings.
[[nodiscard]] IdentifiedJoint found_joint(const AssembliesResult& found);

/// One of the assemblies. @param assembly  from 0.
[[nodiscard]] IdentifiedJoint found_joint(const AssembliesResult& found, std::size_t assembly);

/// One joint of a structure.
[[nodiscard]] IdentifiedJoint found_joint(const CalibrationResult& found,
                                          const CalibratedJoint& joint);

/// All levels, modes, joints and pairs of joints of a structure.
[[nodiscard]] CalibrationSummary found_calibration(const CalibrationResult& found);

}  // namespace microslip
