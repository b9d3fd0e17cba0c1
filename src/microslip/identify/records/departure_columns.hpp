// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/identify/evidence/evidence_verdicts.hpp"
#include "microslip/identify/records/departure_fit.hpp"
#include "microslip/identify/records/record_signals.hpp"

/// @file
/// What departures from a Masing joint do to the force of a record. Internal: Eigen stays out of
/// the installed headers.

namespace microslip {

/// The forms in which a departure may be in a record: each a set of columns, with the signs that
/// physics gives them. Empty for kOther.
/// @param departure  that is sought. @param signals  of the record.
[[nodiscard]] std::vector<DepartureColumns> forms_of(RecordDeparture departure,
                                                     const RecordSignals& signals);

}  // namespace microslip
