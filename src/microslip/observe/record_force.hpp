// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/joint/joint.hpp"
#include "microslip/observe/record_evidence.hpp"

/// @file
/// The force that a joint has on the path of a record.

namespace microslip {

/// The force of a joint at each sample of a record, N, with the offset of its group: the mean of
/// what was measured more than the joint has. NaN where the state of the joint is not known.
/// @param evidence  of the record.
/// @param joint     that was identified.
/// @param viscous   c of a viscous part beside it, N s/m; 0 for none.
[[nodiscard]] std::vector<double> found_force(const RecordEvidence& evidence, const Joint& joint,
                                              double viscous);

}  // namespace microslip
