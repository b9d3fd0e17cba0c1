// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/observe/record_evidence.hpp"

namespace microslip {

/// Checks that the work over a closed part of a record is positive, as it is of any joint that
/// dissipates, whatever its state before, stiffening springs beside it, and an offset of the force
/// [postulate of Ilyushin]:
///
///     W = ∮ F du > −1 % of ∫ |(F − F̄) du|,    F̄ = ∫ F |du| / ∫ |du|.
///
/// The part lies between the first and the last crossing of a displacement: that of the first row,
/// of the last row or the middle of the range, whichever leaves the longest way. Within 1 % of 0,
/// and where no part over a tenth of the range is closed, the force is that of a spring, which must
/// rise with the displacement from one row to the next. All of these are integrals over the path:
/// how samples are spread in time does not matter.
/// @throws InputError  naming W, or the correlation of the increments; what to change follows from
///                     the sign of the latter.
void check_polarity(const RecordEvidence& evidence);

}  // namespace microslip
