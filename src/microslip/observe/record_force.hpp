// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/joint/joint.hpp"
#include "microslip/observe/record_evidence.hpp"

/// @file
/// Force of a joint along the path of a record.

namespace microslip {

/// The force of a joint at each sample of a record, N, with the offset of its group: the mean of
/// measured less predicted force. NaN where the state of the joint is not known.
/// @param evidence  of the record.
/// @param joint     the identified joint.
/// @param viscous   c of a viscous part beside it, N s/m; 0 for none.
[[nodiscard]] std::vector<double> found_force(const RecordEvidence& evidence, const Joint& joint,
                                              double viscous);

/// Size of a force where another is known, N: rms about its mean. 0 where it is nowhere.
/// @param measured, found  of each sample; found NaN where it is not known.
[[nodiscard]] double rms_of_known(const std::vector<double>& measured,
                                  const std::vector<double>& found);

/// What a found force leaves of a measured one, 1: the rms of their difference over
/// rms_of_known(). NaN where none is known.
/// @param measured, found  as of rms_of_known().
[[nodiscard]] double unexplained_share(const std::vector<double>& measured,
                                       const std::vector<double>& found);

}  // namespace microslip
