// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_departures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "microslip/identify/records/departure_columns.hpp"
#include "microslip/identify/records/departure_fit.hpp"
#include "microslip/identify/records/steady_turns.hpp"
#include "microslip/observe/neighbour_scatter.hpp"

namespace microslip {
namespace {

/// A departure is detected where it explains more of the force than so many times the noise would,
constexpr double kOverNoise = 5.0;
/// and more than this share of it: paths are not known better.
constexpr double kLeastDeparture = 4e-3;
/// The joint takes up most of a part in step with the velocity: less of it is left.
constexpr double kLeastRate = 1.5e-3;
/// What is left below this share of the force is not compared further.
constexpr double kLeastLeft = 3e-4;

/// Columns describe a small departure; the residual of a large one looks like others. So another
/// counts in addition only where it explains so much of what the first does.
constexpr double kBesideAnother = 1.0 / 3.0;

/// Rows that are worth as much as independent ones, of residuals that are no noise: so many that a
/// coefficient more must explain 5 % of the square of what is left.
constexpr double kRowsOfModel = 100.0;

/// One that leaves at most so many times what the best does, and explains at least this share of
/// what that does, explains the record as well: two mechanisms may act alike on one motion.
constexpr double kLeavesAsLittle = 1.15;
constexpr double kExplainsAsMuch = 0.8;

/// A record is of another joint where taking it with others costs it more of its force than this.
constexpr double kLeastContradiction = 3e-2;

/// A departure in its best form.
struct Judged {
  RecordVerdict verdict;
  std::size_t form = 0;
  double score = std::numeric_limits<double>::infinity();  ///< the least is the best
};

/// Bayesian information criterion of what is left.
double score_of(double left, double freedom) {
  return 2.0 * kRowsOfModel * std::log(std::max(left, kLeastLeft)) +
         freedom * std::log(kRowsOfModel);
}

/// A departure with its forms.
struct Sought {
  RecordDeparture departure;
  std::vector<DepartureColumns> forms;
};

Judged judge(const Sought& sought, const DepartureFit& fit) {
  Judged judged;
  judged.verdict.departure = sought.departure;
  const double before = fit.without().share;
  for (std::size_t f = 0; f < sought.forms.size(); ++f) {
    const double freedom = sought.forms[f].freedom;
    const DepartureFit::Left left = fit.with(sought.forms[f]);
    const double score = score_of(left.share, freedom);
    if (score >= judged.score) continue;
    judged.form = f;
    judged.score = score;
    judged.verdict.share = std::sqrt(std::max(0.0, before * before - left.share * left.share));
    judged.verdict.noise = left.noise * std::sqrt(freedom);
  }
  const bool is_rate = sought.departure == RecordDeparture::kRate;
  judged.verdict.broken = judged.verdict.share > std::max(kOverNoise * judged.verdict.noise,
                                                          is_rate ? kLeastRate : kLeastDeparture);
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

/// Scatter of the force of a sample, N. What a joint leaves is more where there is a departure.
double scatter_of_samples(const ForceRecord& measured) {
  std::vector<double> number(measured.size());
  std::iota(number.begin(), number.end(), 0.0);
  return scatter_about_neighbours(number, measured.force);
}

/// The departures with a form, but for those that a record which repeats itself cannot have.
std::vector<Sought> sought_in(const SettledRecords& settled, const ScaledRecords& records,
                              std::size_t record) {
  const std::optional<TurnTrend> trend =
      turn_trend(records.records[record], scatter_of_samples(records.records[record].measured()));
  const bool steady = trend && trend->steady();
  const RecordSignals signals(settled, record);
  std::vector<Sought> all;
  for (const RecordDeparture departure : kRecordDepartures) {
    if (departure == RecordDeparture::kOther) continue;
    const bool possible = !(steady && changes_over_time(departure));
    all.push_back(
        {departure, possible ? forms_of(departure, signals) : std::vector<DepartureColumns>()});
  }
  return all;
}

/// Departures that were not found beside the first, but explain the record as well instead of it,
/// come behind it.
void add_alternatives(const std::vector<Judged>& alone, std::vector<RecordVerdict>& verdicts) {
  const RecordDeparture first = verdicts.front().departure;
  const auto best =
      std::ranges::find(alone, first, [](const Judged& one) { return one.verdict.departure; });
  const double most = best->score + 2.0 * kRowsOfModel * std::log(kLeavesAsLittle);
  const double least = kExplainsAsMuch * best->verdict.share;
  auto place = verdicts.begin() + 1;
  for (const Judged& one : alone) {
    if (&one == &*best || !one.verdict.broken) continue;
    if (one.score > most || one.verdict.share < least) continue;
    const auto found =
        std::ranges::find(place, verdicts.end(), one.verdict.departure, &RecordVerdict::departure);
    if (found == verdicts.end() || found->broken) continue;
    *found = one.verdict;
    found->alternative = true;
    std::rotate(place, found, found + 1);
    ++place;
  }
}

/// The detected departures that have columns; the one that explains most first.
std::vector<RecordVerdict> departures_of(const SettledRecords& settled,
                                         const ScaledRecords& records, std::size_t record) {
  DepartureFit fit(settled, record);
  std::vector<Sought> open = sought_in(settled, records, record);
  std::vector<RecordVerdict> verdicts;
  std::vector<Judged> alone;
  double least = 0.0;
  while (!open.empty()) {
    std::vector<Judged> judged;
    for (const Sought& one : open) {
      judged.push_back(judge(one, fit));
      RecordVerdict& verdict = judged.back().verdict;
      verdict.broken = verdict.broken && verdict.share > least;
    }
    const auto most = std::ranges::min_element(judged, {}, [](const Judged& one) {
      return one.verdict.broken ? one.score : std::numeric_limits<double>::infinity();
    });
    if (alone.empty()) alone = judged;
    if (!most->verdict.broken) {
      for (const Judged& one : judged) verdicts.push_back(one.verdict);
      break;
    }
    verdicts.push_back(most->verdict);
    least = std::max(least, kBesideAnother * most->verdict.share);
    const auto chosen = open.begin() + (most - judged.begin());
    fit.add(chosen->forms[most->form]);
    open.erase(chosen);
  }
  if (verdicts.front().broken) add_alternatives(alone, verdicts);
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
