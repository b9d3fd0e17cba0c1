// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_departures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "microslip/identify/records/drift_rows.hpp"
#include "microslip/identify/records/joined_columns.hpp"
#include "microslip/identify/records/steady_turns.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A departure is detected where it explains more of the force than so many times the noise would,
constexpr double kOverNoise = 5.0;
/// and more than this share of it: paths are not known better.
constexpr double kLeastDeparture = 4e-3;

/// Columns describe a small departure; the residual of a large one looks like others. So another
/// counts in addition only where it explains so much of what the first does.
constexpr double kBesideAnother = 0.25;

/// A record is of another joint where taking it with others costs it more of its force than this.
constexpr double kLeastContradiction = 3e-2;

/// Terms of a drift of the displacement, and its size over the largest half range.
constexpr Index kDriftTerms = 2;
constexpr double kDriftSize = 0.02;

/// The rows of a record as the departures see them, each of largest absolute value 1.
struct RowSignals {
  VectorXd force;  // of the joint that was found
  VectorXd velocity;
  VectorXd time;                // from −1 to 1
  VectorXd work;                // dissipated by the joint, from −1 to 1
  VectorXd range;               // of the stretch from the last turn over the largest
  MatrixXd displacement_drift;  // of the joint, to a drift of its path
};

VectorXd normalised(VectorXd values) {
  const double largest = values.cwiseAbs().maxCoeff();
  return largest > 0.0 ? VectorXd(values / largest) : values;
}

/// Scales values to −1 to 1.
VectorXd from_end_to_end(VectorXd values) {
  const double low = values.minCoeff();
  const double width = values.maxCoeff() - low;
  if (width > 0.0) values = (2.0 / width * (values.array() - low) - 1.0).matrix();
  return values;
}

RowSignals signals_of(const SettledRecords& settled, const RecordEvidence& record, std::size_t r) {
  const std::vector<PathRow>& rows = record.rows().rows;
  const auto n = static_cast<Index>(rows.size());
  RowSignals all;
  all.force = normalised(settled.model.found(r, settled.best.solution.x));
  all.velocity.resize(n);
  all.time.resize(n);
  all.work.resize(n);
  all.range.resize(n);
  double work = 0.0;
  for (Index i = 0; i < n; ++i) {
    const PathRow& row = rows[static_cast<std::size_t>(i)];
    all.velocity(i) = row.velocity;
    all.time(i) = static_cast<double>(row.first) + 0.5 * static_cast<double>(row.count);
    if (i > 0) {
      const PathRow& before = rows[static_cast<std::size_t>(i) - 1];
      work += 0.5 * (all.force(i) + all.force(i - 1)) * (row.displacement - before.displacement);
    }
    all.work(i) = work;
    all.range(i) = row.last.half_range / record.rows().reach;
  }
  all.velocity = normalised(all.velocity);
  all.displacement_drift = displacement_drift_rows(settled, r, kDriftTerms, kDriftSize);
  all.time = from_end_to_end(all.time);
  all.work = from_end_to_end(all.work);
  return all;
}

MatrixXd columns_of(RecordDeparture departure, const RowSignals& of) {
  const auto g = of.force.array();
  MatrixXd columns;
  switch (departure) {
    case RecordDeparture::kRate:
      columns = of.velocity;
      break;
    case RecordDeparture::kAsymmetry:
      columns.resize(g.size(), 2);
      columns << g.abs().matrix(), g.square().matrix();
      break;
    case RecordDeparture::kDeadZone: {
      constexpr double kWidth = 0.1;
      columns.resize(g.size(), 2);
      columns << (g / kWidth).tanh().matrix(),
          (of.velocity.array().sign() * (-(g / kWidth).square()).exp()).matrix();
      break;
    }
    case RecordDeparture::kDrift:
      columns.resize(g.size(), 2);
      columns << of.time.cwiseProduct(of.force), of.work.cwiseProduct(of.force);
      break;
    case RecordDeparture::kOffset:
      columns.resize(g.size(), 2);
      columns << of.time, of.time.cwiseAbs2();
      break;
    case RecordDeparture::kRange:
      columns = of.velocity.array().sign() * of.range.array().square();
      break;
    case RecordDeparture::kDisplacementDrift:
      columns = of.displacement_drift;
      break;
    case RecordDeparture::kOther:  // no column: against_others()
      break;
  }
  return columns;
}

struct Judged {
  RecordVerdict verdict;
  MatrixXd columns;  // among the rows of all
  double gain = 0.0;
};

Judged judge(const SettledRecords& settled, std::size_t record, RecordDeparture departure,
             const RowSignals& signals, const JoinedColumns& joined) {
  Judged judged;
  MatrixXd columns = columns_of(departure, signals);
  judged.columns = columns_among_all(settled, record, columns);
  const JoinedColumns::Explained explained = joined.explain(judged.columns);
  settled.model.centre(record, columns);
  const double force = settled.model.force_norm(record);
  judged.gain = explained.gain;
  RecordVerdict& verdict = judged.verdict;
  verdict.departure = departure;
  verdict.share = (columns * explained.coefficients).norm() / force;
  verdict.noise = std::sqrt((columns.transpose() * columns * explained.covariance).trace()) / force;
  verdict.broken = verdict.share > std::max(kOverNoise * verdict.noise, kLeastDeparture);
  return judged;
}

/// The residual of one record with the joint of all beyond that with its own joint, against the
/// effect of noise on the coefficients of the latter.
RecordVerdict against_others(const SettledRecords& settled, const ScaledRecords& records,
                             std::size_t record) {
  std::optional<double> known;
  if (records.stiffness_known) known = records.stiffness;
  const ScaledRecords itself({.records = records.records.subspan(record, 1)}, known,
                             records.coefficients);
  const SettledRecords own = settle_records(itself, settled.settings.viscous);
  const double own_share =
      own.model.residual(0, own.best.solution.x).norm() / own.model.force_norm(0);
  const double share = settled.model.residual(record, settled.best.solution.x).norm() /
                       settled.model.force_norm(record);
  const auto rows = static_cast<double>(itself.records.front().rows().rows.size());
  RecordVerdict verdict;
  verdict.departure = RecordDeparture::kOther;
  verdict.share = std::sqrt(std::max(0.0, share * share - own_share * own_share));
  verdict.noise = own_share * std::sqrt(own.best.edf / rows);
  verdict.broken = verdict.share > std::max(kOverNoise * verdict.noise, kLeastContradiction);
  return verdict;
}

/// A record that repeats itself has none of these. Their columns would explain what a joint misses
/// while the motion grows.
bool changes_over_time(RecordDeparture departure) {
  return departure == RecordDeparture::kDrift || departure == RecordDeparture::kOffset;
}

/// The detected departures that have columns; the largest first.
std::vector<RecordVerdict> departures_of(const SettledRecords& settled,
                                         const ScaledRecords& records, std::size_t record) {
  const RowSignals signals = signals_of(settled, records.records[record], record);
  JoinedColumns joined(settled);
  std::vector<RecordVerdict> verdicts;
  std::vector<RecordDeparture> open(kRecordDepartures.begin(), kRecordDepartures.end() - 1);
  const std::optional<TurnTrend> trend =
      turn_trend(records.records[record],
                 settled.settings.scatter[record] * records.stiffness * records.length);
  const bool steady = trend && trend->steady();
  double least = 0.0;
  while (!open.empty()) {
    std::vector<Judged> judged;
    for (const RecordDeparture departure : open) {
      judged.push_back(judge(settled, record, departure, signals, joined));
      RecordVerdict& verdict = judged.back().verdict;
      verdict.broken =
          verdict.broken && verdict.share > least && !(steady && changes_over_time(departure));
    }
    const auto most = std::ranges::max_element(
        judged, {}, [](const Judged& one) { return one.verdict.broken ? one.gain : 0.0; });
    if (!most->verdict.broken) {
      for (const Judged& one : judged) verdicts.push_back(one.verdict);
      break;
    }
    verdicts.push_back(most->verdict);
    least = std::max(least, kBesideAnother * most->verdict.share);
    joined.add(most->columns);
    open.erase(open.begin() + (most - judged.begin()));
  }
  return verdicts;
}

}  // namespace

std::vector<RecordVerdict> judge_record(const SettledRecords& settled, const ScaledRecords& records,
                                        std::size_t record) {
  std::vector<RecordVerdict> verdicts = departures_of(settled, records, record);
  if (records.records.size() < 2) return verdicts;
  const RecordVerdict other = against_others(settled, records, record);
  if (!other.broken) {
    verdicts.push_back(other);
    return verdicts;
  }
  for (RecordVerdict& verdict : verdicts) verdict.broken = false;
  verdicts.insert(verdicts.begin(), other);
  return verdicts;
}

}  // namespace microslip
