// SPDX-License-Identifier: MIT
#include "microslip/observe/record_evidence.hpp"

#include <utility>

namespace microslip {
namespace {

PathRows rows_of(const ForceRecord& record, const SmoothedPath& path, PathStart start) {
  return path_rows(path.displacement, record.force, start, path.smallest_turn(),
                   RecordEvidence::kMostRows, path.corners);
}

const ForceRecord& checked(const ForceRecord& record) {
  check_force_record(record);
  return record;
}

}  // namespace

RecordEvidence::RecordEvidence(ForceRecord measured, PathStart start)
    : measured_(std::move(measured)),
      path_(smooth_path(checked(measured_).displacement)),
      start_(start),
      rows_(rows_of(measured_, path_, start)) {}

RecordEvidence RecordEvidence::from(PathStart start) const {
  RecordEvidence other = *this;
  if (start == start_) return other;
  other.start_ = start;
  other.rows_ = rows_of(measured_, path_, start);
  return other;
}

}  // namespace microslip
