// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "microslip/dynamics/harmonic/continuation.hpp"

/// @file
/// The corners of a curve, where a heavy atom starts or ceases to slip on a branch of a joint's
/// motion, or where two of its maxima become equal, so that inner and outer loop change places. The
/// equations are continuous there and their derivatives jump, by a matrix of rank one: v gᵀ with g
/// the gradient of the extent of the branch, or of the difference of the maxima. The curve arrives
/// by the null vector of the derivatives on the one side and leaves by that on the other side, with
/// the sign that leads there: g grows along both, or falls along both. It may turn by any angle
/// there, also back in frequency. [Allgower & Georg, Numerical Continuation Methods, Springer 1990,
/// ch. 12-14]

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr double kAhead = 1.5;        // an onset this much farther than a step is aimed at
constexpr double kBeside = 1e-8;      // of an onset, relative: the derivatives of one side
constexpr double kMostBeside = 1e-6;  // of z, relative
constexpr double kLeastAhead = 0.8;   // cosine of tangent and chord
constexpr int kFewIterations = 12;    // towards an onset that may not lie on the curve
constexpr std::size_t kMostTies = 4;  // that are tried in a step
constexpr int kMostOnsetsAtOnce = 4;  // that one corner may hold

}  // namespace

/// For each branch the atom that slips next and the one that slips last, those with a distance
/// first. By the slipping behind the point, which at a corner rounding would hide.
void Continuation::add_neighbours(Point& point) const {
  const auto joints = equations_.structure().joints();
  const VectorXd rate = point.scale.cwiseProduct(point.onward.tangent);
  std::size_t first = 0;  // number of the joint
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::vector<double>& slip_force = equations_.atoms(j);
    const auto counts = point.slipping.begin() + static_cast<std::ptrdiff_t>(first) + 1;
    for (std::size_t rank = 0; rank < equations_.reaches(j).size(); ++rank) {
      std::size_t next = 0;
      while (next < slip_force.size() && counts[static_cast<std::ptrdiff_t>(next)] > rank) ++next;
      for (const std::size_t atom : {next, next - 1}) {
        if (atom >= slip_force.size()) continue;  // none, 0 − 1 included
        const Onset onset{j, rank, slip_force[atom] / joints[j].joint.stiffness()};
        const double miss = equations_.miss(onset);
        const double slope = equations_.miss_gradient(onset) * rate;
        const bool closes = atom == next ? slope > 0.0 : slope < 0.0;
        point.neighbours.push_back({onset, miss, closes ? std::abs(miss / slope) : HUGE_VAL});
      }
    }
    first += 1 + slip_force.size();
  }
  std::ranges::sort(point.neighbours, {}, &Neighbour::distance);
}

/// The tangent behind a corner. Other onsets may be passed along it: then once more with the
/// derivatives there.
template <typename Condition>
bool Continuation::leave(const Condition& at, double sign, double aside, Point& corner) {
  VectorXd tangent = corner.arrival.tangent;
  std::vector<std::size_t> side;
  for (int attempt = 0; attempt < kMostOnsetsAtOnce; ++attempt) {
    const VectorXd step = corner.scale.cwiseProduct(tangent);
    equations_.evaluate(corner.z + aside * step);
    if (attempt > 0 && equations_.slipping() == side) {
      corner.slipping = std::move(side);
      return true;
    }
    side = equations_.slipping();
    corner.onward =
        ray_at(corner.scale, sign * equations_.miss_gradient(at) * corner.scale.asDiagonal());
    tangent = corner.onward.tangent;
    if (!tangent.allFinite()) return false;
    const double slope =
        std::abs((equations_.miss_gradient(at) * corner.scale.cwiseProduct(tangent)).value());
    aside = std::min(kBeside / slope, kMostBeside);
  }
  return false;
}

/// The corner at an onset or a tie, from near it: on the curve ahead, with nothing between. The
/// length becomes that up to it.
template <typename Condition>
bool Continuation::turn(const Point& point, const Condition& at, VectorXd z, double& length,
                        Point& next) {
  const Index n = equations_.balance_count();
  if (!(z[n] > 0.0 && z[n + 1] > 0.0)) return false;
  const NewtonOptions few{options_.newton.tolerance,
                          std::min(kFewIterations, options_.newton.max_iterations)};
  const NewtonResult result = newton(equations_, kept_, at, few, z, near_);
  summary_.iterations += result.iterations;
  if (!result.converged || change(point, z) > 2.0 * options_.largest_change) return false;
  const VectorXd chord = (z - point.z).cwiseQuotient(point.scale);
  const double ahead = chord.dot(point.onward.tangent);
  if (!(ahead > 0.0) || ahead < kLeastAhead * chord.norm() || ahead > 2.0 * kAhead * length) {
    return false;
  }
  Point corner = place_at(z);
  const VectorXd direction = (z - point.z).cwiseQuotient(corner.scale).normalized();
  const VectorXd step = corner.scale.cwiseProduct(direction);
  const double slope = equations_.miss_gradient(at) * step;
  const double aside = std::min(kBeside / std::abs(slope), kMostBeside);
  equations_.evaluate(z - aside * step);
  if (equations_.slips_otherwise(equations_.slipping(), point.slipping)) return false;
  const double sign = slope > 0.0 ? 1.0 : -1.0;
  corner.arrival =
      ray_at(corner.scale, sign * equations_.miss_gradient(at) * corner.scale.asDiagonal());
  if (direction.dot(corner.arrival.tangent) < kLeastAhead) return false;
  if (!leave(at, sign, aside, corner)) return false;
  if (std::is_same_v<Condition, Onset> && corner.slipping == point.slipping) return false;
  add_neighbours(corner);
  corner.is_peak = corner.arrival.gain_slope > 0.0 && corner.onward.gain_slope < 0.0;
  next = std::move(corner);
  length = ahead;
  quick_ = true;
  summary_.residual = std::max(summary_.residual, result.residual);
  return true;
}

/// The next onset, where the tangent leads to it within the length or a bit more.
bool Continuation::reach_corner(const Point& point, double& length, Point& next) {
  if (point.neighbours.empty()) return false;
  const auto& [onset, miss, distance] = point.neighbours.front();
  if (!(distance < kAhead * length)) return false;
  return turn(point, onset, predicted(point, distance), length, next);
}

/// The first onset between the point and where the equations are evaluated.
bool Continuation::corner_between(const Point& point, double& length, Point& next) {
  std::vector<std::pair<double, Onset>> passed;
  for (const Neighbour& neighbour : point.neighbours) {
    const double there = equations_.miss(neighbour.onset);
    const double share = neighbour.miss / (neighbour.miss - there);
    if (neighbour.miss * there < 0.0) passed.emplace_back(share, neighbour.onset);
  }
  if (passed.empty()) return false;
  const auto first =
      std::ranges::min_element(passed, {}, [](const auto& entry) { return entry.first; });
  return turn(point, first->second, predicted(point, first->first * length), length, next);
}

/// Goes to the next tie, as to the next onset. Most curves turn little there, and steps pass it:
/// this is for the others.
bool Continuation::reach_tie(const Point& point, double& length, Point& next) {
  equations_.evaluate(point.z);
  const VectorXd rate = point.scale.cwiseProduct(point.onward.tangent);
  std::vector<std::pair<double, Tie>> ahead;
  for (const Tie& tie : equations_.ties()) {
    const double miss = equations_.miss(tie);
    const double distance = -miss / (equations_.miss_gradient(tie) * rate).value();
    if (std::abs(miss) <= kBeside) continue;  // the point is on it
    if (distance > 0.0 && distance < kAhead * length) ahead.emplace_back(distance, tie);
  }
  std::ranges::sort(ahead, {}, [](const auto& entry) { return entry.first; });
  if (ahead.size() > kMostTies) ahead.resize(kMostTies);
  return std::ranges::any_of(ahead, [&](const auto& entry) {
    return turn(point, entry.second, predicted(point, entry.first), length, next);
  });
}

}  // namespace microslip
