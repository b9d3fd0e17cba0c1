// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/observe/record_evidence.hpp"

namespace microslip {

/// The state in which a record begins, as detected: virgin where a virgin joint explains the
/// samples that one of unknown state cannot, to twice the scatter of the others and 0.4 % of the
/// force. Where too little of a record is left without them, it is assumed virgin.
struct RecordStart {
  PathStart start = PathStart::kVirgin;  ///< detected or assumed
  bool shown = true;                     ///< false: assumed
  /// rms of those samples about a virgin joint, over that scatter; 0 where assumed.
  double early_misfit = 0.0;
};

/// @param evidence  of any start. @throws InputError  as invert_records().
[[nodiscard]] RecordStart shown_start(const RecordEvidence& evidence);

}  // namespace microslip
