// SPDX-License-Identifier: MIT
#include "microslip/identify/record_start.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "microslip/identify/record_settling.hpp"

namespace microslip {
namespace {

/// The density has as many coefficients as it needs to show a virgin joint from another.
constexpr int kCoefficients = 30;
/// Samples that a virgin joint misses by more than so many scatters of the others are those of a
/// joint that had slipped.
constexpr double kMostMisfit = 2.0;
/// Rows that a state must leave to be judged by.
constexpr std::size_t kFewestRows = 100;

/// Per sample, of the rows for which `counts` holds, N.
template <typename Counts>
double misfit(const RecordEvidence& evidence, const Counts& counts) {
  const ScaledRecords records(std::span(&evidence, 1), {});
  const SettledRecords settled = settle_records(records, kCoefficients, false);
  const PathRows& path = evidence.rows();
  const Eigen::VectorXd left = settled.model.residual(0, settled.best.solution.x);
  double sum = 0.0;
  double rows = 0.0;
  for (std::size_t i = 0; i < path.rows.size(); ++i) {
    if (!counts(path.rows[i])) continue;
    const double value = left(static_cast<Eigen::Index>(i));
    sum += value * value * static_cast<double>(path.rows[i].count);
    rows += 1.0;
  }
  if (rows == 0.0) return 0.0;
  return records.stiffness * records.length * std::sqrt(sum / rows);
}

/// Of each sample whether it is in a row.
std::vector<bool> samples_in(const PathRows& path, std::size_t size) {
  std::vector<bool> in(size, false);
  for (const PathRow& row : path.rows) {
    for (std::size_t i = 0; i < row.count; ++i) in[row.first + i] = true;
  }
  return in;
}

}  // namespace

RecordStart shown_start(const RecordEvidence& evidence) {
  const RecordEvidence virgin = evidence.from(PathStart::kVirgin);
  const RecordEvidence unknown = evidence.from(PathStart::kUnknown);
  if (unknown.rows().rows.size() < kFewestRows) return {PathStart::kVirgin, false, 0.0};
  const double scatter = misfit(unknown, [](const PathRow&) { return true; });
  const std::vector<bool> known = samples_in(unknown.rows(), evidence.measured().size());
  const double early = misfit(virgin, [&](const PathRow& row) { return !known[row.first]; });
  const double over = early / scatter;
  return {over > kMostMisfit ? PathStart::kUnknown : PathStart::kVirgin, true, over};
}

}  // namespace microslip
