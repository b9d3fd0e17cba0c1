// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/observe/record_evidence.hpp"
#include "microslip/observe/sensor_drift.hpp"

namespace microslip {

/// Result of fit_drift().
struct DriftFit {
  SensorDrift drift = {};         ///< of each sensor that drifts; empty of one that does not
  double displacement_std = 0.0;  ///< of its drift at the last sample, m; 0 of one without
  double force_std = 0.0;         ///< of its drift at the last sample, N; 0 of one without
};

/// Finds how the zeros of the sensors of a record drift, together with the joint: the force of the
/// joint along u − d_u, plus d_F, is fitted by Gauss–Newton. Each is a polynomial of up to third
/// order (first, with fewer than four turns). Both are sought first, and left where they are no
/// larger than their errors by 2 ln n per coefficient (χ²), n the number of rows; one stays where
/// it is larger by ln n per coefficient beside the other (BIC), and where neither is, the larger
/// does. A drift of the displacement differs from a motion of the joint in that the force does not
/// answer to it; where all of the joint slips in each cycle, the force answers to neither, and the
/// drift does no harm.
/// @param evidence   of the record, of a state as it is known.
/// @param stiffness  k of the stuck joint, N/m, where it is known.
/// @param options    of the inversion that follows.
/// @throws InputError  as invert_records().
[[nodiscard]] DriftFit fit_drift(const RecordEvidence& evidence, std::optional<double> stiffness,
                                 const RecordInversionOptions& options);

}  // namespace microslip
