// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/observe/record_evidence.hpp"

namespace microslip {

/// Checks that the work over a record is positive, as a joint dissipates: with the path closed by a
/// straight line from its end to its start, so that no offset of the force matters,
///
///     W = ∫ F du − ½ (F_first + F_last) (u_last − u_first) > −1 % of ∫ |(F − mean F) du|.
///
/// Within 1 % of 0 the force is that of a spring, which must rise with the displacement from one
/// row to the next. How samples are spread in time does not matter for either.
/// @throws InputError  naming W, or the correlation of the increments; what to change follows from
///                     the sign of the latter.
void check_polarity(const RecordEvidence& evidence);

}  // namespace microslip
