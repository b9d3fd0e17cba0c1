// SPDX-License-Identifier: MIT
#include "microslip/identify/records/steady_turns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/observe/turning_samples.hpp"

namespace microslip {
namespace {

/// Forces at turns that are equal to this share of half their range, and to so many deviations, are
/// those of steady cycles.
constexpr double kSteady = 5e-3;
constexpr double kSteadyDeviations = 3.0;
/// Noise that would hide a change of this share shows no steady cycles, either.
constexpr double kHidden = 0.02;
/// Turns are alike within this share of the range of the path.
constexpr double kAlikeTurns = 0.02;
/// They show a trend where this share of all turns has others that are alike.
constexpr double kMostTurns = 0.7;

struct TurnForce {
  double number;
  double place;
  double range;  // behind it, with the sign of the direction
  double force;
};

/// A line through forces over the number of their turn.
struct TurnLine {
  double change = 0.0;    // over the numbers that it covers
  double variance = 0.0;  // of that
};

TurnLine line_through(const std::vector<TurnForce>& turns, double scatter) {
  const auto n = static_cast<double>(turns.size());
  double number = 0.0;
  double force = 0.0;
  for (const TurnForce& turn : turns) {
    number += turn.number / n;
    force += turn.force / n;
  }
  double square = 0.0;
  double product = 0.0;
  for (const TurnForce& turn : turns) {
    square += (turn.number - number) * (turn.number - number);
    product += (turn.number - number) * (turn.force - force);
  }
  const double slope = product / square;
  double left = 0.0;
  for (const TurnForce& turn : turns) {
    left += std::pow(turn.force - force - slope * (turn.number - number), 2);
  }
  const double variance = std::max(scatter * scatter, n > 2.0 ? left / (n - 2.0) : 0.0);
  const auto [first, last] = std::ranges::minmax(turns, {}, &TurnForce::number);
  const double span = last.number - first.number;
  return {slope * span, span * span * variance / square};
}

/// Parts of turns of which a value is the same within a width.
std::vector<std::vector<TurnForce>> alike(std::vector<TurnForce> turns, double TurnForce::*value,
                                          double width) {
  std::ranges::sort(turns, {}, value);
  std::vector<std::vector<TurnForce>> groups;
  for (const TurnForce& turn : turns) {
    if (groups.empty() || turn.*value - groups.back().front().*value > width) {
      groups.emplace_back();
    }
    groups.back().push_back(turn);
  }
  return groups;
}

}  // namespace

bool TurnTrend::steady() const {
  const double most = std::max(kSteady, kSteadyDeviations * noise);
  return most <= kHidden && change <= most;
}

std::optional<TurnTrend> turn_trend(const RecordEvidence& evidence, double scatter) {
  const std::vector<double>& path = evidence.path().displacement;
  const std::vector<double>& force = evidence.measured().force;
  const std::vector<std::size_t> at = turning_samples(path, evidence.path().smallest_turn());
  const auto [low, high] = std::ranges::minmax(path);
  const double width = kAlikeTurns * (high - low);
  std::vector<TurnForce> turns;
  // The first and the last are the ends of the record, and the second is behind a part of a cycle.
  for (std::size_t k = 2; k + 1 < at.size(); ++k) {
    turns.push_back(
        {static_cast<double>(k), path[at[k]], path[at[k]] - path[at[k - 1]], force[at[k]]});
  }
  double grouped = 0.0;
  double square = 0.0;
  double variance = 0.0;
  for (const std::vector<TurnForce>& same_range : alike(turns, &TurnForce::range, width)) {
    for (const std::vector<TurnForce>& same : alike(same_range, &TurnForce::place, width)) {
      if (same.size() < 2) continue;
      const auto n = static_cast<double>(same.size());
      const TurnLine line = line_through(same, scatter);
      grouped += n;
      square += n * line.change * line.change;
      variance += n * line.variance;
    }
  }
  if (grouped == 0.0 || grouped < kMostTurns * static_cast<double>(turns.size())) return {};
  const auto [least, most] = std::ranges::minmax(force);
  const double half = 0.5 * (most - least);
  return TurnTrend{std::sqrt(square / grouped) / half, std::sqrt(variance / grouped) / half};
}

}  // namespace microslip
