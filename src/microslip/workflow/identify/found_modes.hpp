// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/workflow/identify/model_frequencies.hpp"

/// @file
/// What frequencies of levels show of the modes of a structure, in its model. Internal to workflow.

namespace microslip {

/// The model with its frequencies corrected where that is asked for, and the deviation of what is
/// left: `frequency_std` is no less than the offset that is not corrected and what remains. As it
/// is where no offset is above the resolution of a resonance.
/// @throws InputError  where it cannot be corrected so.
void set_found_modes(const FoundModes& modes, ModelFrequencies asked, ModelFile& model);

/// Lines of the summary; empty where no offset is above the resolution of a resonance.
[[nodiscard]] std::string describe_found_modes(const CalibrationResult& found,
                                               ModelFrequencies asked);

}  // namespace microslip
