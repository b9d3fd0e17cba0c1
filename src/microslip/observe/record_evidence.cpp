// SPDX-License-Identifier: MIT
#include "microslip/observe/record_evidence.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace microslip {
namespace {

/// Turns of noise are smaller than so many of its standard deviations.
constexpr double kTurnDeviations = 6.0;

PathRows rows_of(const ForceRecord& record, const SmoothedPath& path, PathStart start) {
  const auto [low, high] = std::ranges::minmax(path.displacement);
  const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * (high - low);
  return path_rows(path.displacement, record.force, start,
                   std::max(kTurnDeviations * path.left, rounding), RecordEvidence::kMostRows);
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
