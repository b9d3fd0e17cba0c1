// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/evidence/evidence_verdicts.hpp"
#include "microslip/identify/records/record_settling.hpp"

/// @file
/// Whether records are those of a joint of the kind that is sought. Internal: Eigen stays out of
/// the installed headers.

namespace microslip {

/// Judges a record: what of the force that the joint leaves, each departure would explain, were it
/// there beside the joint. Its columns join those of the joint, which may give way to them; what
/// they explain of the residual is held against what they would of noise alone. The departure that
/// explains most is the verdict; the others are judged with its columns among those of the joint,
/// so that they do not stand for it. Of several records each is also held against what its own
/// joint leaves: where that of all leaves much more, the record is of another.
/// @param settled  the joint. @param records  of it. @param record  index of the one to judge.
[[nodiscard]] std::vector<RecordVerdict> judge_record(const SettledRecords& settled,
                                                      const ScaledRecords& records,
                                                      std::size_t record);

}  // namespace microslip
