// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/harmonic/bordered_factors.hpp"

namespace microslip {
namespace {

/// Keeps the first warnings of each code, with the number of the others.
std::vector<Warning> few_of_each(std::vector<Warning> warnings) {
  constexpr std::size_t kFew = 3;
  std::vector<Warning> kept;
  std::map<std::string, std::size_t> count;
  for (Warning& warning : warnings) {
    if (++count[warning.code] <= kFew) kept.push_back(std::move(warning));
  }
  for (const auto& [code, number] : count) {
    if (number <= kFew) continue;
    const auto last = std::ranges::find(kept.rbegin(), kept.rend(), code, &Warning::code);
    last->text += fmt::format("; also at {} more places", number - kFew);
  }
  return kept;
}

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Whether `along` is past the limit in the direction of the sign.
bool beyond(double along, double limit, double sign) { return sign * (along - limit) > 0.0; }

constexpr double kSmallestLength = 1e-10;  // of a step, relative
constexpr double kKinkLength = 1e-4;       // what still turns is another kink
constexpr double kLeastCosine = 0.8;       // of the angles between two tangents and the chord
constexpr double kLargestGap = 0.1;        // of a step and the mean of its slopes, relative
constexpr int kQuickIterations = 5;        // Newton's: the step may grow

}  // namespace

Continuation::Continuation(BalanceEquations& equations, ContinuationOptions options,
                           const Target& kept, Quantity along, double from, double to)
    : equations_(equations),
      options_(std::move(options)),
      kept_(kept),
      along_(along),
      from_(from),
      to_(to) {}

/// The scale of z where the equations were evaluated.
VectorXd Continuation::scale() const {
  VectorXd scale = equations_.scale();
  if (along_ == Quantity::kAngularFrequency) {
    scale[equations_.balance_count()] = std::abs(to_ - from_);
  }
  return scale;
}

/// The derivative of the quantity that changes along the curve by relative z: of ln of the
/// response, of the others over their scale.
RowVectorXd Continuation::along_row(const VectorXd& scale) const {
  const Index n = equations_.balance_count();
  if (along_ == Quantity::kResponse) {
    return equations_.log_response_gradient() * scale.asDiagonal();
  }
  return RowVectorXd::Unit(n + 2, along_ == Quantity::kForceAmplitude ? n + 1 : n);
}

/// Tangent and side alone: from the factors of the last Newton step, where they cost much.
Continuation::Ray Continuation::directed(const VectorXd& scale, const RowVectorXd& towards) const {
  const RowVectorXd kept = equations_.miss_gradient(kept_);
  Ray ray;
  if (near_.are_costly()) {
    if (const auto tangent = near_.tangent(equations_, kept)) {
      ray.tangent = tangent->direction.cwiseQuotient(scale).normalized();
      const int sign = towards.dot(ray.tangent) > 0.0 ? 1 : -1;
      ray.tangent *= sign;
      ray.side = sign * tangent->determinant_sign;
      return ray;
    }
  }
  BorderedFactors factors;
  factors.compute(equations_, scale, kept * scale.asDiagonal(), towards);
  const Index n = equations_.balance_count();
  ray.tangent = factors.solve(VectorXd::Unit(n + 2, n + 1)).normalized();
  ray.side = factors.determinant_sign();
  return ray;
}

/// The tangent is the null vector of the balance and the kept target on the positive side of
/// `towards`. The equations must be evaluated at the point, or beside it on the side that counts.
Continuation::Ray Continuation::ray_at(const VectorXd& scale, const RowVectorXd& towards) const {
  const Index n = equations_.balance_count();
  Ray ray = directed(scale, towards);
  // With geometric stiffness the modes that are eliminated have a determinant of either sign.
  if (equations_.structure().shortens()) ray.side = 0;
  ray.along_slope = along_row(scale) * ray.tangent;
  const RowVectorXd log_response = equations_.log_response_gradient() * scale.asDiagonal();
  ray.gain_slope = log_response * ray.tangent - ray.tangent[n + 1];
  const Eigen::RowVectorXcd response = equations_.response_gradient() / equations_.response();
  ray.change_rate = std::abs((response * scale.asDiagonal() * ray.tangent).value());
  const auto joints = static_cast<Index>(equations_.structure().joints().size());
  for (Index j = 0; j < joints; ++j) {
    const Index block = n / joints;
    ray.change_rate = std::max(ray.change_rate, ray.tangent.segment(j * block, block).norm());
  }
  return ray;
}

/// Without its rays. The equations must be evaluated at z.
Continuation::Point Continuation::place_at(const VectorXd& z) const {
  Point point;
  point.z = z;
  point.scale = scale();
  point.response = equations_.response();
  point.along = equations_.value(along_);
  point.height = equations_.value(kept_.quantity == Quantity::kResponse ? Quantity::kForceAmplitude
                                                                        : Quantity::kResponse);
  return point;
}

/// A point without a corner, its tangent on the side of `direction`, or, at the start, towards the
/// end of the range. The equations must be evaluated at z.
Continuation::Point Continuation::point_at(const VectorXd& z, const VectorXd* direction) const {
  Point point = place_at(z);
  RowVectorXd towards;
  if (direction != nullptr) {
    towards = direction->transpose();
  } else {
    towards = along_row(point.scale) * (to_ < from_ ? -1.0 : 1.0);
  }
  point.arrival = ray_at(point.scale, towards);
  point.onward = point.arrival;
  point.slipping = equations_.slipping();
  add_neighbours(point);
  return point;
}

/// Extrapolates the rotation of the tangent from those of two points. Only across it, so that the
/// plane on which the next point is sought is unchanged.
void Continuation::add_curvature(const Point& before, double length, Point& point) {
  const VectorXd old = before.onward.tangent.cwiseProduct(before.scale).cwiseQuotient(point.scale);
  VectorXd& curvature = point.onward.curvature;
  const VectorXd& tangent = point.onward.tangent;
  curvature = (tangent * old.norm() - old) / (length * old.norm() * old.norm());
  curvature -= tangent * tangent.dot(curvature);
}

/// The length after which the curve has changed by as much as is wanted, by the tangent.
double Continuation::wanted_length(const Point& point) const {
  double length = options_.largest_change / std::max(point.onward.change_rate, 1e-12);
  const double slope = options_.least_points * std::abs(point.onward.along_slope) + 1e-12;
  if (along_ == Quantity::kAngularFrequency) {
    length = std::min(length, 1.0 / slope);
  } else {  // along is relative: over ln of the range
    length = std::min(length, std::abs(std::log(to_ / from_)) / slope);
  }
  return std::min(length, longest_);
}

/// Where the derivatives jump: two rays.
bool Continuation::is_corner(const Point& point) {
  return point.arrival.tangent != point.onward.tangent;
}

/// A point over the distance from another along a normal, both relative to the scale there.
HermiteKnot Continuation::knot(const Point& point, const Ray& ray, const Point& origin,
                               const VectorXd& normal) {
  const VectorXd over = normal.cwiseQuotient(origin.scale);
  const VectorXd slope = point.scale.cwiseProduct(ray.tangent);
  return {over.dot(point.z - origin.z), point.z, slope / over.dot(slope)};
}

/// Prediction by tangent and curvature.
VectorXd Continuation::predicted(const Point& from, double length) {
  const Ray& ray = from.onward;
  VectorXd z = from.z + length * from.scale.cwiseProduct(ray.tangent);
  if (ray.curvature.size() > 0) {
    z += 0.5 * length * length * from.scale.cwiseProduct(ray.curvature);
  }
  return z;
}

NewtonResult Continuation::correct(const Point& from, double length, VectorXd& z) {
  const VectorXd& tangent = from.onward.tangent;
  const Index n = equations_.balance_count();
  z = predicted(from, length);
  if (!(z[n] > 0.0 && z[n + 1] > 0.0)) {
    return {.converged = false, .residual = HUGE_VAL, .iterations = 0, .reason = "step too long"};
  }
  const Place place{from.z + length * from.scale.cwiseProduct(tangent),
                    tangent.transpose() * from.scale.cwiseInverse().asDiagonal()};
  NewtonResult result = newton(equations_, kept_, place, options_.newton, z, near_);
  summary_.iterations += result.iterations;
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

/// A point whose energy balance is below rounding ends the curve.
bool Continuation::add(Point point) {
  equations_.evaluate(point.z);
  SteadyVibration vibration = equations_.vibration();
  const std::string doubt = energy_doubt(vibration, options_.newton.tolerance);
  if (doubt.empty()) {
    rows_.push_back({std::move(point), std::move(vibration)});
    report_progress(rows_.back().point.along);
    return true;
  }
  stop(Stop::kDoubtful, fmt::format("{}, {}", doubt, place(point)));
  return false;
}

std::string Continuation::place(const Point& point) const {
  const Index n = equations_.balance_count();
  std::string text = fmt::format("at {}, {}", describe({Quantity::kAngularFrequency, point.z[n]}),
                                 drive_text(point.z[n + 1], equations_.structure().base_driven()));
  if (along_ == Quantity::kResponse) text += ", " + describe({along_, point.along});
  return text;
}

void Continuation::stop(Stop why, const std::string& reason) {
  summary_.stop = why;
  summary_.reason = reason;
}

/// Reports the progress in thousandths of the range, which never falls, even where a curve turns
/// back.
void Continuation::report_progress(double along) {
  constexpr std::size_t kWhole = 1000;
  farthest_ = std::clamp((along - from_) / (to_ - from_), farthest_, 1.0);
  const auto done = static_cast<std::size_t>(farthest_ * static_cast<double>(kWhole));
  if (progress_ && !progress_(done, kWhole)) throw Cancelled();
}

void Continuation::run(const VectorXd& z, ResponseCurve& curve, const Progress& progress) {
  summary_ = curve.summary;
  progress_ = progress;
  follow(z);
  if (along_ == Quantity::kAngularFrequency) {
    if (options_.accuracy > 0.0) draw_closely();
    if (!options_.frequencies.empty()) add_frequencies();
  }
  hand_over(curve);
}

/// Rows become the points of the curve, with the marks on them.
void Continuation::hand_over(ResponseCurve& curve) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].point.is_peak) {
      curve.peaks.push_back(rows_[i].vibration);
      curve.peak_points.push_back(i);
    }
    if (i == 0 || i + 1 == rows_.size()) continue;
    const double before = rows_[i].point.along - rows_[i - 1].point.along;
    const double after = rows_[i + 1].point.along - rows_[i].point.along;
    if (before * after < 0.0) curve.turning_points.push_back(i);
  }
  for (Row& row : rows_) curve.points.push_back(std::move(row.vibration));
  curve.summary = summary_;
  curve.warnings = few_of_each(std::move(warnings_));
}

/// Sets the quantity that changes along the curve to an exact value, where a solution has it up to
/// rounding, and evaluates the equations there. A response is not an unknown and is left.
void Continuation::put(double along, VectorXd& z) {
  const Index n = equations_.balance_count();
  if (along_ == Quantity::kAngularFrequency) z[n] = along;
  if (along_ == Quantity::kForceAmplitude) z[n + 1] = along;
  equations_.evaluate(z);
}

void Continuation::follow(VectorXd z) {
  put(from_, z);
  Point point = point_at(z, nullptr);
  if (!add(point)) return;
  double length = wanted_length(point);
  while (step(point, length)) {
    if (static_cast<int>(rows_.size()) >= options_.max_points) {
      stop(Stop::kLimit,
           fmt::format("max_points = {} reached {}", options_.max_points, place(point)));
      rows_.erase(rows_.begin() + options_.max_points, rows_.end());
      return;
    }
  }
  if (summary_.converged()) report_progress(to_);
}

/// The next point: a corner where one lies as near as that; else the step is halved until Newton's
/// method converges, nothing changes by too much, no atom starts or ceases to slip in between, and
/// the tangent turns by so little that its direction is certain.
bool Continuation::find_next(const Point& point, double& length, Point& next) {
  const double longest = wanted_length(point);
  length = std::min(length, longest);
  NewtonResult result;
  for (; length >= kSmallestLength * longest; length *= 0.5) {
    if (reach_corner(point, length, next)) return true;
    VectorXd z;
    result = correct(point, length, z);
    if (!result.converged && reach_tie(point, length, next)) return true;
    if (!result.converged || change(point, z) > 2.0 * options_.largest_change) continue;
    const bool kink = length < kKinkLength * longest;
    if (equations_.slips_otherwise(equations_.slipping(), point.slipping)) {
      if (corner_between(point, length, next)) return true;
      if (!kink) continue;
      equations_.evaluate(z);
    }
    const VectorXd step = point.scale.cwiseProduct(point.onward.tangent);
    const VectorXd direction = step.cwiseQuotient(scale()).normalized();
    next = point_at(z, &direction);
    const double chord = (z - point.z).cwiseQuotient(point.scale).norm();
    const bool turns =
        direction.dot(next.arrival.tangent) < kLeastCosine || length < kLeastCosine * chord;
    const bool other_sense = next.arrival.side != point.onward.side;
    if (!kink && (turns || other_sense || !smooth(point, length, next))) continue;
    add_curvature(point, length, next);
    summary_.residual = std::max(summary_.residual, result.residual);
    quick_ = result.iterations - result.kept <= kQuickIterations;
    return true;
  }
  summary_.residual = std::max(summary_.residual, result.residual);
  stop(Stop::kNoProgress,
       fmt::format("Newton's method finds no further point {}: {}", place(point),
                   result.converged ? "the curve bends too sharply" : result.reason));
  return false;
}

/// Whether `along` changed as its slopes at both ends indicate. Only that distinguishes the flanks
/// of a narrow resonance: a step from one to the other would reverse the curve.
bool Continuation::smooth(const Point& point, double length, const Point& next) const {
  const double slope = point.onward.along_slope;
  const double slope_there = next.arrival.along_slope;
  const double range = along_ == Quantity::kAngularFrequency ? std::abs(to_ - from_) : point.along;
  const double moved = (next.along - point.along) / range;
  if (slope * slope_there > 0.0) return moved * slope_there >= 0.0;
  const double expected = 0.5 * length * (slope + slope_there);
  const double size = std::abs(moved) + 0.5 * length * (std::abs(slope) + std::abs(slope_there));
  return std::abs(moved - expected) <= kLargestGap * size;
}

/// One more point, and the peak and the fold before it; false where the curve ends.
bool Continuation::step(Point& point, double& length) {
  Point next;
  if (!find_next(point, length, next)) return false;
  const double ahead = to_ > from_ ? 1.0 : -1.0;
  const bool ends = beyond(next.along, to_, ahead);
  const bool returns = beyond(next.along, from_, -ahead);
  for (auto& [here, found] : located(point, length, next)) add(std::move(found));
  if (ends || returns) {
    if (!land(point, next, ends ? to_ : from_)) return false;
    stop(ends ? Stop::kConverged : Stop::kNoProgress,
         ends ? "reached the end of the range"
              : fmt::format("the curve turned back and left the range where it began, {}",
                            place(next)));
    return false;
  }
  if (!add(next) || retraces()) return false;
  if (quick_) length *= 2.0;
  point = std::move(next);
  return true;
}

/// The last point, exactly at the limit: from the chord, or, where the curve turns behind it, from
/// the tangent.
bool Continuation::land(const Point& before, const Point& after, double limit) {
  const double left = limit - before.along;
  const VectorXd chord = (after.z - before.z) / (after.along - before.along);
  const VectorXd tangent =
      before.scale.cwiseProduct(before.onward.tangent) / before.onward.along_slope;
  NewtonResult result;
  for (const VectorXd& direction : {chord, tangent}) {
    VectorXd z = before.z + left * direction;
    result = newton(equations_, kept_, Target{along_, limit}, options_.newton, z, near_);
    summary_.iterations += result.iterations;
    if (!result.converged) continue;
    summary_.residual = std::max(summary_.residual, result.residual);
    put(limit, z);
    const VectorXd forward = (after.z - before.z).cwiseQuotient(scale());
    return add(point_at(z, &forward));
  }
  summary_.residual = std::max(summary_.residual, result.residual);
  stop(Stop::kNoProgress,
       fmt::format("the last point, {}, was not found: {}",
                   describe({along_, limit}, equations_.structure().base_driven()), result.reason));
  return false;
}

bool Continuation::in_range(const Point& point) const {
  return !beyond(point.along, std::max(from_, to_), 1.0) &&
         !beyond(point.along, std::min(from_, to_), -1.0);
}

/// The peak and the fold inside of a step, by their places in it.
std::map<double, Continuation::Point> Continuation::located(const Point& from, double length,
                                                            const Point& to) {
  struct Kind {
    Slope slope;
    bool is_peak;
  };
  const double sense = from.onward.along_slope;
  const std::array kinds{Kind{[](const Ray& ray) { return ray.gain_slope; }, true},
                         Kind{[sense](const Ray& ray) { return sense * ray.along_slope; }, false}};
  std::map<double, Point> found;
  for (const auto& [slope, is_peak] : kinds) {
    if (!(slope(from.onward) > 0.0 && slope(to.arrival) < 0.0)) continue;
    Point point;
    std::string reason;
    const auto here = vanishing(from, length, slope(to.arrival), slope, point, reason);
    if (here && in_range(point)) {
      equations_.evaluate(point.z);
      reason = energy_doubt(equations_.vibration(), options_.newton.tolerance);
      point.is_peak = is_peak;
      if (reason.empty()) found.emplace(*here, std::move(point));
    }
    if (is_peak && !reason.empty()) {
      warnings_.push_back({"peak_not_located",
                           fmt::format("the peak {} was not located: {}", place(from), reason)});
    }
  }
  return found;
}

/// Where a slope that is positive at `from` passes 0, by false position over the length of the
/// step; that of an end that is kept twice in a row is halved (Illinois).
std::optional<double> Continuation::vanishing(const Point& from, double length, double there,
                                              const Slope& slope_of, Point& found,
                                              std::string& reason) {
  constexpr int kMostSteps = 60;
  constexpr double kNear = 1e-7;  // of the step
  const double start = slope_of(from.onward);
  double low = 0.0;
  double high = length;
  double slope_low = start;
  double slope_high = there;
  int moved = 0;  // the end that moved last: −1 low, 1 high
  for (int step = 0; step < kMostSteps; ++step) {
    const double here = low + (high - low) * slope_low / (slope_low - slope_high);
    VectorXd z;
    const NewtonResult result = correct(from, here, z);
    if (!result.converged) {
      reason = result.reason;
      return std::nullopt;
    }
    found = point_at(z, &from.onward.tangent);
    const double slope = slope_of(found.arrival);
    const bool narrow = std::min(here - low, high - here) < kNear * length;
    if (std::abs(slope) <= 1e-9 * start || narrow) return here;
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
  reason = fmt::format("its slope does not vanish in {} steps", kMostSteps);
  return std::nullopt;
}

}  // namespace microslip
