// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_polarity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// A record may return this share of the work exchanged: noise.
constexpr double kMostGiven = 1e-2;
/// A closed part of a record over less than this share of its range may be one of noise.
constexpr double kLeastSpan = 0.1;
/// A correlation of increments beyond this shows that the force rises, or falls, with the
/// displacement; that of a damper is about 0.
constexpr double kClearCorrelation = 0.1;

constexpr std::string_view kChangeSign =
    "Change the sign of one channel, or take the channels of this joint.";
constexpr std::string_view kExchange =
    "Force and displacement may be swapped, or the force may lag behind the displacement: give "
    "each its channel, without delay.";
constexpr std::string_view kEither =
    "Change the sign of one channel; or force and displacement may be swapped.";

struct Point {
  double u;  ///< m
  double f;  ///< N
};

/// The part of a record between its first and its last crossing of a displacement: closed, whatever
/// the joint.
std::vector<Point> between_crossings(const std::vector<double>& u, const std::vector<double>& f,
                                     double level) {
  std::vector<Point> part;
  std::size_t closed = 0;
  const auto cross = [&](Point point) {
    part.push_back(point);
    closed = part.size();
  };
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (i > 0 && (u[i] - level) * (u[i - 1] - level) < 0.0) {
      const double share = (level - u[i - 1]) / (u[i] - u[i - 1]);
      cross({level, f[i - 1] + share * (f[i] - f[i - 1])});
    }
    if (u[i] == level) {
      cross({level, f[i]});
    } else if (closed > 0) {
      part.push_back({u[i], f[i]});
    }
  }
  part.resize(closed);
  return part;
}

double travel_of(const std::vector<Point>& path) {
  double travel = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) travel += std::abs(path[i].u - path[i - 1].u);
  return travel;
}

/// The longest closed part of a record that begins or ends with it, or crosses the middle of its
/// range; empty where none spans a tenth of the range.
std::vector<Point> closed_part(const std::vector<double>& u, const std::vector<double>& f) {
  const auto [low, high] = std::ranges::minmax(u);
  std::vector<Point> longest;
  for (const double level : {u.front(), u.back(), 0.5 * (low + high)}) {
    std::vector<Point> part = between_crossings(u, f, level);
    if (part.empty()) continue;
    const auto [least, most] = std::ranges::minmax(part, {}, &Point::u);
    if (most.u - least.u < kLeastSpan * (high - low)) continue;
    if (travel_of(part) > travel_of(longest)) longest = std::move(part);
  }
  return longest;
}

struct Work {
  double done = 0.0;       ///< J
  double exchanged = 0.0;  ///< J
};

Work work_of(const std::vector<Point>& path) {
  double mean = 0.0;
  const double travel = travel_of(path);
  for (std::size_t i = 1; i < path.size(); ++i) {
    mean += 0.5 * (path[i].f + path[i - 1].f) * std::abs(path[i].u - path[i - 1].u) / travel;
  }
  Work work;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step = (0.5 * (path[i].f + path[i - 1].f) - mean) * (path[i].u - path[i - 1].u);
    work.done += step;
    work.exchanged += std::abs(step);
  }
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
  const Work work = work_of(closed_part(evidence.path().displacement, evidence.measured().force));
  const double least = kMostGiven * work.exchanged;
  if (work.done > least) return;
  const double together = correlation_of_increments(evidence.rows());
  if (work.done >= -least) {
    if (together > 0.0) return;
    throw InputError("correlation of the increments of force and displacement", together,
                     "must be positive: the force of a spring rises with the displacement",
                     kChangeSign);
  }
  throw InputError("work over the record, J", work.done,
                   "must be positive: a joint dissipates energy",
                   together < -kClearCorrelation  ? kChangeSign
                   : together > kClearCorrelation ? kExchange
                                                  : kEither);
}

}  // namespace microslip
