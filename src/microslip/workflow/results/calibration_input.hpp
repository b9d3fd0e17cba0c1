// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/documents/joint/identified_joint.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/identify/calibration_results.hpp"

/// @file
/// The files that calibrate writes, and modal_levels.csv, as results. Internal to workflow.

namespace microslip {

/// calibration.csv. @throws FormatError  where a column is missing, or a mode is none.
[[nodiscard]] LevelsOfModes calibrated_levels_of(const NamedInput& input);

/// modal_levels.csv without its model: what was measured.
/// @throws FormatError  where a column is missing, or a mode is none.
[[nodiscard]] LevelsOfModes modal_levels_of(const NamedInput& input);

/// identifiability.csv, a density a joint in their order there; or densities.csv, one an assembly,
/// with the band of the next one alone.
/// @throws FormatError  where a column is missing, or slip forces of a joint do not rise.
[[nodiscard]] std::vector<DensityFound> densities_of(const NamedInput& input);

/// The density of a joint with its band, and its variance reduction where its file has it.
[[nodiscard]] DensityFound density_found_of(const std::string& name, const IdentifiedJoint& joint);

}  // namespace microslip
