// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_start.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "microslip/identify/records/drift_fit.hpp"
#include "microslip/identify/records/record_settling.hpp"

namespace microslip {
namespace {

/// The density has as many coefficients as are needed to distinguish a virgin joint from another.
constexpr int kCoefficients = 30;
/// Samples that a virgin joint misses by more than so many scatters of the others are those of a
/// joint that had slipped.
constexpr double kMostMisfit = 2.0;
/// Rows that a state must leave to be judged by.
constexpr std::size_t kFewestRows = 100;

/// No force is known to more than this share of the largest: the path is not, either. Rows of many
/// samples would show irrelevant deviations.
constexpr double kForceFloor = 4e-3;

/// Residual of a virgin or another joint with its record, N.
struct Left {
  Eigen::VectorXd residual;  ///< of each row
  double scatter;            ///< of a sample
  double largest;            ///< force of a row
};

Left left_of(const RecordEvidence& evidence) {
  const ScaledRecords records({.records = std::span(&evidence, 1)}, {}, kCoefficients);
  const SettledRecords settled = settle_records(records, false);
  const double force = records.stiffness * records.length;
  const Eigen::VectorXd& x = settled.best.solution.x;
  return {force * settled.model.residual(0, x), force * settled.settings.scatter.front(),
          force * settled.model.found(0, x).cwiseAbs().maxCoeff()};
}

/// rms of the rows for which `counts` holds, over that expected of noise and floor.
template <typename Counts>
double misfit(const Left& left, double scatter, const PathRows& path, const Counts& counts) {
  const double floor = kForceFloor * left.largest;
  double sum = 0.0;
  double rows = 0.0;
  for (std::size_t i = 0; i < path.rows.size(); ++i) {
    if (!counts(path.rows[i])) continue;
    const double value = left.residual(static_cast<Eigen::Index>(i));
    const auto samples = static_cast<double>(path.rows[i].count);
    sum += value * value / (scatter * scatter / samples + floor * floor);
    rows += 1.0;
  }
  return rows > 0.0 ? std::sqrt(sum / rows) : 0.0;
}

/// Whether each sample is in a row.
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
  const double scatter = left_of(unknown).scatter;
  const std::vector<bool> known = samples_in(unknown.rows(), evidence.measured().size());
  const auto early_misfit = [&](const RecordEvidence& assumed) {
    return misfit(left_of(assumed), scatter, assumed.rows(),
                  [&](const PathRow& row) { return !known[row.first]; });
  };
  const double over = early_misfit(virgin);
  if (over <= kMostMisfit) return {PathStart::kVirgin, true, over};
  // Offsets of an unknown state hide a drift, and a virgin joint misses one.
  const SensorDrift drift = fit_drift(virgin, {}, {.coefficients = kCoefficients}).drift;
  if (drift.force.empty() && drift.displacement.empty()) return {PathStart::kUnknown, true, over};
  const RecordEvidence corrected(without_drift(virgin.measured(), drift), PathStart::kVirgin);
  const double beside = early_misfit(corrected);
  return {beside <= kMostMisfit ? PathStart::kVirgin : PathStart::kUnknown, true,
          std::min(over, beside)};
}

}  // namespace microslip
