// SPDX-License-Identifier: MIT
#pragma once

namespace microslip {

/// Frequencies of the modes of the model that a calibration writes.
enum class ModelFrequencies {
  kGiven,      ///< as in the model that was read; offsets found are in their standard deviations
  kCorrected,  ///< with the offsets that the levels show
};

}  // namespace microslip
