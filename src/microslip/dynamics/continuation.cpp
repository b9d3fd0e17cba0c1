// SPDX-License-Identifier: MIT
#include "microslip/dynamics/continuation.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Whether `along` is past the limit in the direction of the sign.
bool beyond(double along, double limit, double sign) { return sign * (along - limit) > 0.0; }

constexpr double kSmallestLength = 1e-10;  // of a step, relative
constexpr double kKinkLength = 1e-4;       // likewise: if the tangent still turns, it jumps
constexpr double kLeastCosine = 0.8;       // of the angles between two tangents and the chord
constexpr double kLargestGap = 0.3;        // of a step and the mean of its slopes, relative
constexpr int kQuickIterations = 5;        // Newton's: the step may grow

double sign_of_determinant(const Eigen::PartialPivLU<MatrixXd>& solver) {
  double sign = static_cast<double>(solver.permutationP().determinant());
  for (const double pivot : solver.matrixLU().diagonal()) sign *= pivot < 0.0 ? -1.0 : 1.0;
  return sign;
}

}  // namespace

Continuation::Continuation(BalanceEquations& equations, const ContinuationOptions& options,
                           const Target& kept, Quantity along, double from, double to)
    : equations_(equations), options_(options), kept_(kept), along_(along), from_(from), to_(to) {}

/// Of z where the equations were evaluated.
VectorXd Continuation::scale() const {
  VectorXd scale = equations_.scale();
  if (along_ == Quantity::kAngularFrequency) {
    scale[equations_.balance_count()] = std::abs(to_ - from_);
  }
  return scale;
}

/// The derivatives of the balance and of the kept target in relative unknowns, and a last row.
MatrixXd Continuation::matrix(const VectorXd& scale, const RowVectorXd& last) const {
  const Index n = equations_.balance_count();
  MatrixXd matrix(n + 2, n + 2);
  matrix.topRows(n) =
      scale.head(n).cwiseInverse().asDiagonal() * equations_.jacobian() * scale.asDiagonal();
  matrix.row(n) = equations_.miss_gradient(kept_) * scale.asDiagonal();
  matrix.row(n + 1) = last;
  return matrix;
}

/// The tangent is the null vector of the balance and the kept target, with the sign of `direction`,
/// or, at the start, towards the end of the range. The equations must be evaluated at z.
Continuation::Point Continuation::point_at(const VectorXd& z, const VectorXd* direction) const {
  const Index n = equations_.balance_count();
  Point point;
  point.z = z;
  point.scale = scale();
  point.response = equations_.response();
  const RowVectorXd log_response = equations_.log_response_gradient() * point.scale.asDiagonal();
  RowVectorXd along = RowVectorXd::Unit(n + 2, along_ == Quantity::kForceAmplitude ? n + 1 : n);
  if (along_ == Quantity::kResponse) along = log_response;

  RowVectorXd last = along;
  if (direction != nullptr) {
    last = direction->transpose();
  } else if (to_ < from_) {
    last = -along;
  }
  const Eigen::PartialPivLU<MatrixXd> solver(matrix(point.scale, last));
  point.tangent = solver.solve(VectorXd::Unit(n + 2, n + 1)).normalized();
  point.orientation = sign_of_determinant(solver);

  point.along = equations_.value(along_);
  point.along_slope = along * point.tangent;
  point.gain_slope = log_response * point.tangent - point.tangent[n + 1];
  const Eigen::RowVectorXcd response = equations_.response_gradient() / equations_.response();
  point.change_rate = std::abs((response * point.scale.asDiagonal() * point.tangent).value());
  const auto joints = static_cast<Index>(equations_.structure().joints().size());
  for (Index j = 0; j < joints; ++j) {
    const Index block = n / joints;
    point.change_rate = std::max(point.change_rate, point.tangent.segment(j * block, block).norm());
  }
  return point;
}

/// From the tangents of two points: how the tangent will go on to turn. Across it alone, so that
/// the plane on which the next point is sought stays where it is.
void Continuation::add_curvature(const Point& before, double length, Point& point) {
  const VectorXd old = before.tangent.cwiseProduct(before.scale).cwiseQuotient(point.scale);
  point.curvature = (point.tangent * old.norm() - old) / (length * old.norm() * old.norm());
  point.curvature -= point.tangent * point.tangent.dot(point.curvature);
}

/// The length after which the curve has changed by as much as is wanted, by the tangent.
double Continuation::wanted_length(const Point& point) const {
  double length = options_.largest_change / std::max(point.change_rate, 1e-12);
  if (along_ == Quantity::kAngularFrequency) {
    length = std::min(length, 1.0 / (options_.least_points * std::abs(point.along_slope) + 1e-12));
  } else {  // along is relative: over ln of the range
    const double range = std::abs(std::log(to_ / from_));
    length =
        std::min(length, range / (options_.least_points * std::abs(point.along_slope) + 1e-12));
  }
  return length;
}

NewtonResult Continuation::correct(const Point& from, double length, VectorXd& z) {
  const VectorXd predicted = from.z + length * from.scale.cwiseProduct(from.tangent);
  const Index n = equations_.balance_count();
  z = predicted;
  if (from.curvature.size() > 0)
    z += 0.5 * length * length * from.scale.cwiseProduct(from.curvature);
  if (!(z[n] > 0.0 && z[n + 1] > 0.0)) {
    return {.converged = false, .residual = HUGE_VAL, .iterations = 0, .reason = "step too long"};
  }
  const Place place{predicted, from.tangent.transpose() * from.scale.cwiseInverse().asDiagonal()};
  NewtonResult result = newton(equations_, kept_, place, options_.newton, z);
  return result;
}

/// Relative change of the response and of the motion of each joint; the equations are those at z.
double Continuation::change(const Point& from, const VectorXd& z) const {
  double change = std::abs(equations_.response() / from.response - 1.0);
  const Index n = equations_.balance_count();
  const auto joints = static_cast<Index>(equations_.structure().joints().size());
  for (Index j = 0; j < joints; ++j) {
    const Index block = n / joints;
    const double moved = (z - from.z).segment(j * block, block).norm();
    change = std::max(change, moved / from.scale[j * block]);
  }
  return change;
}

/// A point whose energy balance is lost in rounding ends the curve.
bool Continuation::add(const VectorXd& z, ResponseCurve& curve) {
  equations_.evaluate(z);
  SteadyVibration vibration = equations_.vibration();
  const std::string doubt = energy_doubt(vibration, options_.newton.tolerance);
  if (doubt.empty()) {
    curve.points.push_back(std::move(vibration));
    return true;
  }
  stop(curve, Status::kNotConverged,
       fmt::format("{}, at {:.9g} Hz, force {:.6g} N", doubt, vibration.frequency(),
                   vibration.force_amplitude));
  return false;
}

std::string Continuation::place(const Point& point) const {
  const Index n = equations_.balance_count();
  std::string text = fmt::format(
      "at {}, force {:.6g} N", describe({Quantity::kAngularFrequency, point.z[n]}), point.z[n + 1]);
  if (along_ == Quantity::kResponse) text += ", " + describe({along_, point.along});
  return text;
}

void Continuation::stop(ResponseCurve& curve, Status status, const std::string& reason) {
  curve.summary.status = status;
  curve.summary.reason = reason;
}

/// In thousandths of the range; a curve that turns back does not take any back.
void Continuation::tell(const Progress& progress, double along) {
  constexpr std::size_t kWhole = 1000;
  farthest_ = std::clamp((along - from_) / (to_ - from_), farthest_, 1.0);
  const auto done = static_cast<std::size_t>(farthest_ * static_cast<double>(kWhole));
  if (progress && !progress(done, kWhole)) throw Cancelled();
}

void Continuation::run(const VectorXd& z, ResponseCurve& curve, const Progress& progress) {
  follow(z, curve, progress);
  curve.summary.reason += missed_;
}

void Continuation::follow(const VectorXd& z, ResponseCurve& curve, const Progress& progress) {
  if (!add(z, curve)) return;
  Point point = point_at(z, nullptr);
  double length = wanted_length(point);
  while (step(point, length, curve)) {
    tell(progress, point.along);
    if (static_cast<int>(curve.points.size()) >= options_.max_points) {
      stop(curve, Status::kNotConverged,
           fmt::format("max_points = {} are used up {}", options_.max_points, place(point)));
      return;
    }
  }
  if (curve.summary.converged()) tell(progress, to_);
}

/// The next point: the step is halved until Newton's method converges, nothing changes by too much,
/// and the tangent turns by so little that it cannot be the other way round.
bool Continuation::find_next(const Point& point, double& length, Point& next,
                             ResponseCurve& curve) {
  const double longest = wanted_length(point);
  length = std::min(length, longest);
  NewtonResult result;
  for (; length >= kSmallestLength * longest; length *= 0.5) {
    VectorXd z;
    result = correct(point, length, z);
    curve.summary.iterations += result.iterations;
    if (!result.converged || change(point, z) > 2.0 * options_.largest_change) continue;
    const VectorXd step = point.scale.cwiseProduct(point.tangent);
    const VectorXd direction = step.cwiseQuotient(scale()).normalized();
    next = point_at(z, &direction);
    const bool kink = length < kKinkLength * longest;  // where the tangent jumps
    const double chord = (z - point.z).cwiseQuotient(point.scale).norm();
    const bool turns = direction.dot(next.tangent) < kLeastCosine || length < kLeastCosine * chord;
    if (!kink && (turns || !smooth(point, length, next))) continue;
    add_curvature(point, length, next);
    curve.summary.residual = std::max(curve.summary.residual, result.residual);
    quick_ = result.iterations <= kQuickIterations;
    return true;
  }
  if (round_corner(point, longest, length, next, curve)) return true;
  curve.summary.residual = std::max(curve.summary.residual, result.residual);
  stop(curve, Status::kNotConverged,
       fmt::format("Newton's method finds no further point {}: {}", place(point),
                   result.converged ? "the curve bends too sharply" : result.reason));
  return false;
}

/// Whether `along` went as its slopes at both ends say. Both flanks of a narrow resonance look the same
/// in all but that: a step from one to the other would turn the curve round.
bool Continuation::smooth(const Point& point, double length, const Point& next) const {
  const double range = along_ == Quantity::kAngularFrequency ? std::abs(to_ - from_) : point.along;
  const double moved = (next.along - point.along) / range;
  if (point.along_slope * next.along_slope > 0.0) return moved * next.along_slope >= 0.0;
  const double expected = 0.5 * length * (point.along_slope + next.along_slope);
  const double size =
      std::abs(moved) + 0.5 * length * (std::abs(point.along_slope) + std::abs(next.along_slope));
  return std::abs(moved - expected) <= kLargestGap * size;
}

/// Where an atom starts to slip the derivatives jump, and the curve may turn by more than a right
/// angle: nothing lies ahead. The tangent behind the corner is that of the derivatives a bit further
/// along the old one. Across the jump, which is of rank one in the derivatives, det(derivatives,
/// tangent) keeps its sign where the tangent leads away from the corner. [Allgower & Georg,
/// Numerical Continuation Methods, Springer 1990, ch. 12-14]
bool Continuation::round_corner(const Point& point, double longest, double& length, Point& next,
                                ResponseCurve& curve) {
  for (double share = 1e-7; share < 2e-2; share *= 10.0) {
    length = share * longest;
    const VectorXd ahead = point.z + length * point.scale.cwiseProduct(point.tangent);
    equations_.evaluate(ahead);
    Point corner = point_at(ahead, &point.tangent);
    corner.z = point.z;
    corner.scale = point.scale;
    if (corner.orientation == point.orientation) continue;
    corner.tangent = -corner.tangent;
    VectorXd z;
    const NewtonResult result = correct(corner, length, z);
    curve.summary.iterations += result.iterations;
    if (!result.converged) continue;
    next = point_at(z, &corner.tangent);
    if (next.orientation != point.orientation || corner.tangent.dot(next.tangent) < kLeastCosine) {
      continue;
    }
    curve.summary.residual = std::max(curve.summary.residual, result.residual);
    quick_ = true;
    return true;
  }
  return false;
}

/// One more point; false where the curve ends.
bool Continuation::step(Point& point, double& length, ResponseCurve& curve) {
  Point next;
  if (!find_next(point, length, next, curve)) return false;
  const double ahead = to_ > from_ ? 1.0 : -1.0;
  const bool ends = beyond(next.along, to_, ahead);
  const bool returns = beyond(next.along, from_, -ahead);
  const bool turns = point.along_slope * next.along_slope < 0.0;
  if (point.gain_slope > 0.0 && next.gain_slope < 0.0) {
    locate_peak(point, length, next.gain_slope, curve);
  }
  if (ends || returns) {
    if (!land(point, next, ends ? to_ : from_, curve)) return false;
    if (turns && returns) curve.turning_points.push_back(curve.points.size() - 1);
    stop(curve, ends ? Status::kConverged : Status::kNotConverged,
         ends ? "reached the end of the range"
              : fmt::format("the curve turned back and left the range where it began, {}",
                            place(next)));
    return false;
  }
  if (!add(next.z, curve)) return false;
  if (turns) curve.turning_points.push_back(curve.points.size() - 1);
  if (quick_) length *= 2.0;
  point = std::move(next);
  return true;
}

/// The last point, exactly at the limit: from the chord, or, where the curve turns behind it, from the
/// tangent.
bool Continuation::land(const Point& before, const Point& after, double limit,
                        ResponseCurve& curve) {
  const double left = limit - before.along;
  const VectorXd chord = (after.z - before.z) / (after.along - before.along);
  const VectorXd tangent = before.scale.cwiseProduct(before.tangent) / before.along_slope;
  NewtonResult result;
  for (const VectorXd& direction : {chord, tangent}) {
    VectorXd z = before.z + left * direction;
    result = newton(equations_, kept_, Target{along_, limit}, options_.newton, z);
    curve.summary.iterations += result.iterations;
    if (!result.converged) continue;
    curve.summary.residual = std::max(curve.summary.residual, result.residual);
    return add(z, curve);
  }
  curve.summary.residual = std::max(curve.summary.residual, result.residual);
  stop(curve, Status::kNotConverged,
       fmt::format("the last point, {}, was not found: {}", describe({along_, limit}),
                   result.reason));
  return false;
}

/// Where d ln(response/force)/ds passes 0, by false position over the length of the step; the slope of
/// an end that is kept twice in a row is halved (Illinois). In the last step it may lie beyond the
/// range, and is left out.
void Continuation::locate_peak(const Point& from, double length, double slope_there,
                               ResponseCurve& curve) {
  constexpr int kMostSteps = 60;
  constexpr double kNear = 1e-7;  // of the step
  double low = 0.0;
  double high = length;
  double slope_low = from.gain_slope;
  double slope_high = slope_there;
  int moved = 0;  // the end that moved last: −1 low, 1 high
  for (int step = 0; step < kMostSteps; ++step) {
    const double here = low + (high - low) * slope_low / (slope_low - slope_high);
    VectorXd z;
    const NewtonResult result = correct(from, here, z);
    curve.summary.iterations += result.iterations;
    if (!result.converged) return miss_peak(from, result.reason);
    const Point point = point_at(z, &from.tangent);
    const double slope = point.gain_slope;
    const bool narrow = std::min(here - low, high - here) < kNear * length;
    if (std::abs(slope) <= 1e-9 * from.gain_slope || narrow) return keep_peak(point, curve);
    if (slope > 0.0) {
      low = here;
      slope_low = slope;
      if (moved == -1) slope_high *= 0.5;
      moved = -1;
    } else {
      high = here;
      slope_high = slope;
      if (moved == 1) slope_low *= 0.5;
      moved = 1;
    }
  }
  miss_peak(from, fmt::format("its slope does not vanish in {} steps", kMostSteps));
}

/// Where it lies in the range and its energy is no rounding. The equations are those at the peak.
void Continuation::keep_peak(const Point& peak, ResponseCurve& curve) {
  if (beyond(peak.along, std::max(from_, to_), 1.0)) return;
  if (beyond(peak.along, std::min(from_, to_), -1.0)) return;
  SteadyVibration vibration = equations_.vibration();
  const std::string doubt = energy_doubt(vibration, options_.newton.tolerance);
  if (!doubt.empty()) return miss_peak(peak, doubt);
  curve.peaks.push_back(std::move(vibration));
}

void Continuation::miss_peak(const Point& near, const std::string& reason) {
  missed_ += fmt::format("; the peak {} was not located: {}", place(near), reason);
}

}  // namespace microslip
