// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_polarity.hpp"

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// A record may return this share of the work exchanged: noise.
constexpr double kMostGiven = 1e-2;
/// A correlation of increments beyond this shows that the force rises, or falls, with the
/// displacement; that of a damper is about 0.
constexpr double kClearCorrelation = 0.1;

constexpr std::string_view kChangeSign =
    "Change the sign of one channel, or take the channels of this joint.";
constexpr std::string_view kExchange =
    "Force and displacement may be swapped, or the force may lead the displacement: give each its "
    "channel, without delay.";
constexpr std::string_view kEither =
    "Change the sign of one channel; or force and displacement may be swapped.";

struct Work {
  double closed = 0.0;     ///< J
  double exchanged = 0.0;  ///< J
};

Work work_of(const std::vector<double>& u, const std::vector<double>& f) {
  double mean = 0.0;
  for (const double value : f) mean += value / static_cast<double>(f.size());
  Work work;
  for (std::size_t i = 1; i < u.size(); ++i) {
    const double step = (0.5 * (f[i] + f[i - 1]) - mean) * (u[i] - u[i - 1]);
    work.closed += step;
    work.exchanged += std::abs(step);
  }
  work.closed -= (0.5 * (f.front() + f.back()) - mean) * (u.back() - u.front());
  return work;
}

/// Of the changes of force and displacement from row to row of one group.
double correlation_of_increments(const PathRows& path) {
  double together = 0.0;
  double of_force = 0.0;
  double of_path = 0.0;
  for (std::size_t i = 1; i < path.rows.size(); ++i) {
    const PathRow& row = path.rows[i];
    const PathRow& before = path.rows[i - 1];
    if (row.group != before.group) continue;
    const double force = row.force - before.force;
    const double moved = row.displacement - before.displacement;
    together += force * moved;
    of_force += force * force;
    of_path += moved * moved;
  }
  const double norm = std::sqrt(of_force * of_path);
  return norm > 0.0 ? together / norm : 0.0;
}

}  // namespace

void check_polarity(const RecordEvidence& evidence) {
  const Work work = work_of(evidence.path().displacement, evidence.measured().force);
  const double least = kMostGiven * work.exchanged;
  if (work.closed > least) return;
  const double together = correlation_of_increments(evidence.rows());
  if (work.closed > -least) {
    if (together > 0.0) return;
    throw InputError("correlation of the increments of force and displacement", together,
                     "must be positive: the force of a spring rises with the displacement",
                     kChangeSign);
  }
  throw InputError("work over the record, J", work.closed,
                   "must be positive: a joint dissipates energy",
                   together < -kClearCorrelation  ? kChangeSign
                   : together > kClearCorrelation ? kExchange
                                                  : kEither);
}

}  // namespace microslip
