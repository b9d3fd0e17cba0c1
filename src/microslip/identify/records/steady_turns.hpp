// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "microslip/observe/record_evidence.hpp"

namespace microslip {

/// How the force at turns that are alike changes over a record: those at the same place, behind
/// ranges as large, in the same direction.
struct TurnTrend {
  double change = 0.0;  ///< rms over the turns, from their first to their last, over half the range
  double noise = 0.0;   ///< its standard deviation, over half the range

  /// Whether the record repeats itself: nothing in it drifts.
  [[nodiscard]] bool steady() const;
};

/// The trend of a record of which most turns are alike; straight lines through the forces over the
/// number of the turn.
/// @param evidence  of any start. @param scatter  of the force of one sample, N.
/// @return nothing where the turns differ, as those of a random motion or of growing cycles.
[[nodiscard]] std::optional<TurnTrend> turn_trend(const RecordEvidence& evidence, double scatter);

}  // namespace microslip
