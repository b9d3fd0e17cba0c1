// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/evidence/evidence_verdicts.hpp"
#include "microslip/identify/records/record_settling.hpp"

/// @file
/// Tests whether records are those of a Masing joint under constant normal load. Internal: Eigen
/// stays out of the installed headers.

namespace microslip {

/// Judges a record: how much less of its force is left where a departure stands beside the joint,
/// which is fitted anew with each of its forms (DepartureFit, forms_of()); that is compared with
/// noise. The departure that explains most is the verdict; the others are judged with its columns
/// among those of the joint, so that they do not stand for it, and one that explains the record as
/// well in its place is an alternative. With several records each is also compared with the
/// residual of its own joint: where that of the joint of all is much larger, the record is of
/// another joint.
/// @param settled  the joint. @param records  all records. @param record  index of the one to
///                 judge.
[[nodiscard]] std::vector<RecordVerdict> judge_record(const SettledRecords& settled,
                                                      const ScaledRecords& records,
                                                      std::size_t record);

}  // namespace microslip
