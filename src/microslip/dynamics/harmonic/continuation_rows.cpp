// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/harmonic/continuation.hpp"

/// @file
/// Points between those of the steps: so many that the polygon through all of them is close to the
/// curve, and those at given frequencies. Peaks, folds and corners are points already; between two
/// neighbours the curve is smooth and monotone in frequency.

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kMostHalvings = 14;        // of the distance between two points of the steps
constexpr double kSameFrequency = 1e-9;  // relative: a vertical piece has no height over frequency
constexpr double kMostBow = 0.5;         // of a point from the chord, over that
constexpr double kMostStrayed = 0.2;     // of a harmonic from where it was expected, over it
constexpr double kLeastHarmonic = 1e-4;  // of the joint's motion: a smaller one counts as so much
constexpr double kFarApart = 0.01;  // in frequency, relative: more than most resonances are wide
constexpr double kNoEnd = 1e-4;     // of a step: so far from its ends a point is another
constexpr int kMostRetraced = 3;    // points in a row: one may be a near miss
/// Distance of a point from a bridge, over its length: a first check, as those that pass are
/// compared with the curve itself by Newton's method. An arc whose tangents make acos 0.8 with its
/// chord, the most that a step turns, lies up to 0.017 of that beside the cubic.
constexpr double kNearPiece = 0.02;
constexpr double kSamePoint = 1e-6;  // relative
constexpr int kWalkSteps = 8;        // between two points without a found one in the middle
constexpr int kMostWalkSteps = 1000;

/// The cubic polynomials of u from 0 to 1 that have one of (value, slope; value, slope) 1, the
/// others 0.
std::array<double, 4> hermite(double u) {
  const double v = 1.0 - u;
  return {v * v * (1.0 + 2.0 * u), u * v * v, u * u * (3.0 - 2.0 * u), -u * u * v};
}

std::array<double, 4> hermite_slope(double u) {
  const double v = 1.0 - u;
  return {-6.0 * u * v, v * (1.0 - 3.0 * u), 6.0 * u * v, u * (3.0 * u - 2.0)};
}

}  // namespace

/// The cubic curve between two points that has their tangents, over u from 0 to 1.
struct Continuation::Bridge {
  Bridge(const Point& a, const Point& b) : from(a), to(b) {
    chord = (b.z - a.z).cwiseQuotient(a.scale);
    length = chord.norm();
    tangent_a = length * a.scale.cwiseProduct(a.onward.tangent);
    stretch_b = length / b.scale.cwiseProduct(b.arrival.tangent).cwiseQuotient(a.scale).norm();
    tangent_b = stretch_b * b.scale.cwiseProduct(b.arrival.tangent);
  }

  [[nodiscard]] VectorXd mix(const std::array<double, 4>& h) const {
    return h[0] * from.z + h[1] * tangent_a + h[2] * to.z + h[3] * tangent_b;
  }

  /// A point of the bridge, moved across a normal onto the polynomial through the points around as
  /// well, where that is not far: over the distance along the normal.
  [[nodiscard]] VectorXd refined(const VectorXd& z, const VectorXd& normal,
                                 const Around& around) const {
    constexpr double kMostOff = 0.1;      // of its length
    constexpr double kLeastAlong = 0.5;   // of its length: else it is steep against the normal
    constexpr double kLeastBeside = 0.2;  // of that: nearer points add little
    constexpr double kMostBeside = 5.0;   // of that: farther ones mislead
    std::vector<HermiteKnot> knots{knot(from, from.onward, from, normal),
                                   knot(to, to.arrival, from, normal)};
    const double along = knots.back().t;
    const double t = normal.cwiseQuotient(from.scale).dot(z - from.z);
    if (!(along > kLeastAlong * length)) return z;
    const auto add = [&](const Point* point, const Ray& ray) {
      HermiteKnot more = knot(*point, ray, from, normal);
      const double beside = more.t < 0.0 ? -more.t : more.t - along;
      if (beside > kLeastBeside * along && beside < kMostBeside * along) {
        knots.push_back(std::move(more));
      }
    };
    if (around.before != nullptr) add(around.before, around.before->onward);
    if (around.after != nullptr) add(around.after, around.after->arrival);
    VectorXd closer = hermite_value(knots, t);
    // A force that is kept is kept to its last digit.
    const Index force = z.size() - 1;
    if (from.z[force] == to.z[force]) closer[force] = z[force];
    const double off = (closer - z).cwiseQuotient(from.scale).norm();
    return off <= kMostOff * length ? closer : z;
  }

  /// Frequency and height, whose slopes follow from those of the rays.
  [[nodiscard]] std::array<double, 2> at(double u, Index frequency, double growth) const {
    const std::array<double, 4> h = hermite(u);
    const double slope_a = growth * length * from.onward.gain_slope * from.height;
    const double slope_b = growth * stretch_b * to.arrival.gain_slope * to.height;
    return {h[0] * from.z[frequency] + h[1] * tangent_a[frequency] + h[2] * to.z[frequency] +
                h[3] * tangent_b[frequency],
            h[0] * from.height + h[1] * slope_a + h[2] * to.height + h[3] * slope_b};
  }

  const Point& from;
  const Point& to;
  VectorXd chord;  // relative
  double length;   // of it
  double stretch_b;
  VectorXd tangent_a;  // by u
  VectorXd tangent_b;
};

namespace {

/// Deviation of a point from the chord between two others, at its frequency.
double beside_chord(const std::array<double, 2>& a, const std::array<double, 2>& b,
                    const std::array<double, 2>& point) {
  const double run = b[0] - a[0];
  if (std::abs(run) <= kSameFrequency * b[0]) return 0.0;
  return std::abs(point[1] - a[1] - (b[1] - a[1]) * (point[0] - a[0]) / run);
}

}  // namespace

/// A solution between two neighbours, if it is: near the bridge, and ahead.
std::optional<Continuation::Row> Continuation::row_between(const Bridge& bridge, const VectorXd& z,
                                                           const NewtonResult& result) {
  if (!result.converged) return std::nullopt;
  const VectorXd moved = (z - bridge.from.z).cwiseQuotient(bridge.from.scale);
  const double share = moved.dot(bridge.chord) / (bridge.length * bridge.length);
  if (!(share > 0.0 && share < 1.0)) return std::nullopt;
  if ((moved - share * bridge.chord).norm() > kMostBow * bridge.length) return std::nullopt;
  const VectorXd direction = (bridge.to.z - bridge.from.z).cwiseQuotient(scale()).normalized();
  Row row{point_at(z, &direction), equations_.vibration()};
  const int side = bridge.from.onward.side;
  if (row.point.arrival.side != side && bridge.to.arrival.side == side) return std::nullopt;
  if (!energy_doubt(row.vibration, options_.newton.tolerance).empty()) return std::nullopt;
  summary_.residual = std::max(summary_.residual, result.residual);
  return row;
}

/// Deviation of a harmonic of a joint's motion from its prediction, relative to the harmonic: over
/// a narrow superharmonic resonance it is of order 1, when little else shows that.
double Continuation::strayed(const Bridge& bridge, const VectorXd& z,
                             const VectorXd& expected) const {
  const auto joints = static_cast<Index>(equations_.structure().joints().size());
  const Index block = equations_.balance_count() / std::max<Index>(1, joints);
  double most = 0.0;
  for (Index first = 0; first < joints * block; first += block) {
    for (Index i = first + 1; i + 1 < first + block; i += 2) {
      const double size =
          std::max({z.segment(i, 2).norm(), bridge.from.z.segment(i, 2).norm(),
                    bridge.to.z.segment(i, 2).norm(), kLeastHarmonic * bridge.from.scale[i]});
      most = std::max(most, (z - expected).segment(i, 2).norm() / size);
    }
  }
  return most;
}

/// Points around two neighbours, the i-th point and the next.
Continuation::Around Continuation::around(std::size_t i) const {
  Around around;
  if (i > 0 && !is_corner(rows_[i].point)) around.before = &rows_[i - 1].point;
  const bool smooth = i + 2 < rows_.size() && !is_corner(rows_[i + 1].point);
  if (smooth) around.after = &rows_[i + 2].point;
  return around;
}

/// At a share of the bridge, on the plane across it; where that leads nowhere, from the chord. The
/// start is on the polynomial that passes through the points around, too, if that is near.
std::optional<Continuation::Row> Continuation::between(const Row& from, const Row& to,
                                                       const Around& around, double share) {
  const Bridge bridge(from.point, to.point);
  const VectorXd on_chord = from.point.z + share * (to.point.z - from.point.z);
  const VectorXd slope =
      bridge.mix(hermite_slope(share)).cwiseQuotient(from.point.scale).normalized();
  const VectorXd on_bridge = bridge.mix(hermite(share));
  for (const bool curved : {true, false}) {
    const Place place{
        curved ? on_bridge : on_chord,
        (curved ? slope : bridge.chord).transpose() * from.point.scale.cwiseInverse().asDiagonal()};
    VectorXd z = curved ? bridge.refined(on_bridge, slope, around) : on_chord;
    const NewtonResult result = newton(equations_, kept_, place, options_.newton, z, near_);
    summary_.iterations += result.iterations;
    auto row = row_between(bridge, z, result);
    if (!row) continue;
    row->strayed = strayed(bridge, z, on_bridge);
    return row;
  }
  return std::nullopt;
}

/// Whether a point lies on a piece between earlier points that was followed in the opposite
/// direction.
bool Continuation::lies_on_earlier_piece(const Point& point) {
  for (std::size_t i = 0; i + 3 < rows_.size(); ++i) {
    const Point& from = rows_[i].point;
    const Point& to = rows_[i + 1].point;
    const auto [low, high] = std::minmax(from.along, to.along);
    if (!(low <= point.along && point.along <= high)) continue;
    if ((to.along - from.along) * point.arrival.along_slope >= 0.0) continue;
    const int side = from.onward.side;
    if (side != 0 && side == point.arrival.side) continue;
    const Bridge bridge(from, to);
    const VectorXd moved = (point.z - from.z).cwiseQuotient(from.scale);
    const double share = moved.dot(bridge.chord) / (bridge.length * bridge.length);
    if (!(share >= 0.0 && share <= 1.0)) continue;
    VectorXd z = bridge.mix(hermite(share));
    const double off = (point.z - z).cwiseQuotient(from.scale).norm();
    if (!(off <= kNearPiece * bridge.length)) continue;
    const Place place{point.z, bridge.chord.transpose() * from.scale.cwiseInverse().asDiagonal()};
    const NewtonResult result = newton(equations_, kept_, place, options_.newton, z);
    summary_.iterations += result.iterations;
    if (!result.converged) continue;
    if ((z - point.z).cwiseQuotient(point.scale).norm() <= kSamePoint) return true;
  }
  return false;
}

/// Ends a curve that reversed and goes back over itself, without the repeated points.
bool Continuation::retraces() {
  retraced_ = lies_on_earlier_piece(rows_.back().point) ? retraced_ + 1 : 0;
  if (retraced_ < kMostRetraced) return false;
  rows_.erase(rows_.end() - kMostRetraced, rows_.end());
  stop(Stop::kNoProgress,
       fmt::format("the curve reversed and goes back over itself, {}", place(rows_.back().point)));
  return true;
}

/// Allowed deviation of the polygon from the curve between each point and the next: of the response
/// by the top of the hill between two valleys, of the force by itself.
std::vector<double> Continuation::allowed_deviations() const {
  std::vector<double> allowed;
  const auto height = [&](std::size_t i) { return rows_[i].point.height; };
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    if (kept_.quantity == Quantity::kResponse) {
      allowed.push_back(options_.accuracy * std::min(height(i), height(i + 1)));
      continue;
    }
    std::size_t top = height(i) < height(i + 1) ? i + 1 : i;
    while (top + 1 < rows_.size() && height(top + 1) > height(top)) ++top;
    while (top > 0 && height(top - 1) > height(top)) --top;
    allowed.push_back(options_.accuracy * height(top));
  }
  return allowed;
}

void Continuation::draw_closely() {
  const std::vector<double> allowed = allowed_deviations();
  std::vector<Row> rows;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows.push_back(rows_[i]);
    if (i + 1 == rows_.size()) break;
    if (static_cast<int>(rows.size() + rows_.size() - i) < options_.max_points) {
      refine(rows_[i], rows_[i + 1], around(i), allowed[i], kMostHalvings, rows);
      continue;
    }
    warnings_.push_back(
        {"not_drawn_closely",
         fmt::format("max_points = {} reached {}: beyond it the interpolation error of the polygon "
                     "through the points may exceed {:g} of the peak",
                     options_.max_points, place(rows_[i].point), options_.accuracy)});
    rows.insert(rows.end(), rows_.begin() + static_cast<std::ptrdiff_t>(i) + 1, rows_.end());
    break;
  }
  rows_ = std::move(rows);
  add_left_out();
}

/// The peaks and folds of narrow bumps that the points between the steps have found.
void Continuation::add_left_out() {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows.push_back(rows_[i]);
    if (i + 1 == rows_.size() || rows_[i].point.is_peak || rows_[i + 1].point.is_peak) continue;
    const Point& from = rows_[i].point;
    const Point& to = rows_[i + 1].point;
    const double length = (to.z - from.z).cwiseQuotient(from.scale).dot(from.onward.tangent);
    if (!(length > 0.0)) continue;
    for (auto& [here, point] : located(from, length, to)) {
      const double share = here / length;  // at an end it is that point itself
      if (!(share > kNoEnd && share < 1.0 - kNoEnd)) continue;
      equations_.evaluate(point.z);
      SteadyVibration vibration = equations_.vibration();
      rows.push_back({std::move(point), std::move(vibration)});
      report_progress(rows.back().point.along);
    }
  }
  rows_ = std::move(rows);
}

/// Shorter steps from a point to the next, where a narrow resonance may lie between; none where
/// they do not lead there.
std::vector<Continuation::Row> Continuation::walk(const Row& from, const Row& to) {
  const VectorXd chord = (to.point.z - from.point.z).cwiseQuotient(from.point.scale);
  const Summary before = summary_;
  longest_ = chord.norm() / kWalkSteps;
  std::vector<Row> rows;
  Point point = from.point;
  double length = longest_;
  bool arrived = false;
  for (int step = 0; step < kMostWalkSteps && !arrived; ++step) {
    Point next;
    if (!find_next(point, length, next)) break;
    const VectorXd left = (to.point.z - next.z).cwiseQuotient(from.point.scale);
    arrived = left.norm() <= 2.0 * longest_ && left.dot(point.onward.tangent) <= 0.0;
    if (arrived) break;
    equations_.evaluate(next.z);
    rows.push_back({next, equations_.vibration()});
    if (quick_) length *= 2.0;
    point = std::move(next);
  }
  longest_ = HUGE_VAL;
  summary_.stop = before.stop;
  summary_.reason = before.reason;
  return arrived ? rows : std::vector<Row>{};
}

std::array<double, 2> Continuation::mark(const Point& point) const {
  return {point.z[equations_.balance_count()], point.height};
}

/// Whether a solved point between two others shows that the polygon through these is too coarse: it
/// lies too far from the chord, or from the prediction by the tangents.
bool Continuation::strays(const Row& from, const Row& to, const Row& row, double allowed) const {
  return beside_chord(mark(from.point), mark(to.point), mark(row.point)) > allowed ||
         row.strayed > kMostStrayed;
}

/// Whether more points are needed between two neighbours: the curve by their tangents lies too far
/// from the chord, or, where they are far apart, points at the thirds deviate. With a narrow
/// superharmonic resonance in between, all else may agree by chance.
bool Continuation::is_coarse(const Row& from, const Row& to, const Around& around, double allowed) {
  const Index n = equations_.balance_count();
  const Bridge bridge(from.point, to.point);
  const double growth = kept_.quantity == Quantity::kResponse ? -1.0 : 1.0;
  for (const double u : {0.25, 0.5, 0.75}) {
    const std::array<double, 2> there = bridge.at(u, n, growth);
    if (beside_chord(mark(from.point), mark(to.point), there) > allowed) return true;
  }
  if (std::abs(to.point.z[n] - from.point.z[n]) <= kFarApart * to.point.z[n]) return false;
  return std::ranges::any_of(std::array{1.0 / 3.0, 2.0 / 3.0}, [&](double share) {
    const std::optional<Row> row = between(from, to, around, share);
    return !row || strays(from, to, *row, allowed);
  });
}

/// The point in the middle is solved, and kept; where it strays, once more in each half, and in
/// that which is too coarse.
void Continuation::refine(const Row& from, const Row& to, const Around& around, double allowed,
                          int depth, std::vector<Row>& rows) {
  const Index n = equations_.balance_count();
  if (std::abs(to.point.z[n] - from.point.z[n]) <= kSameFrequency * to.point.z[n]) return;
  const std::optional<Row> middle = between(from, to, around, 0.5);
  if (!middle) {
    refine_steps(from, to, allowed, depth, rows);
    return;
  }
  const bool deeper = depth > 1;
  const bool far = deeper && strays(from, to, *middle, allowed);
  const Around first{around.before, &to.point};
  const Around second{&from.point, around.after};
  if (far || (deeper && is_coarse(from, *middle, first, allowed))) {
    refine(from, *middle, first, allowed, depth - 1, rows);
  }
  rows.push_back(*middle);
  report_progress(middle->point.along);
  if (far || (deeper && is_coarse(*middle, to, second, allowed))) {
    refine(*middle, to, second, allowed, depth - 1, rows);
  }
}

/// Refines between points of shorter steps, where none was found in the middle.
void Continuation::refine_steps(const Row& from, const Row& to, double allowed, int depth,
                                std::vector<Row>& rows) {
  const std::vector<Row> steps = depth > 1 ? walk(from, to) : std::vector<Row>{};
  if (steps.empty()) {
    warnings_.push_back({"not_drawn_closely",
                         fmt::format("no point was found between those {} and {}: the polygon may "
                                     "miss the curve there",
                                     place(from.point), place(to.point))});
    return;
  }
  for (std::size_t i = 0; i <= steps.size(); ++i) {
    refine(i == 0 ? from : steps[i - 1], i < steps.size() ? steps[i] : to, {}, allowed,
           std::max(depth - 3, 1), rows);
    if (i == steps.size()) break;
    rows.push_back(steps[i]);
    report_progress(steps[i].point.along);
  }
}

/// Where the bridge has a frequency that lies between those of its ends.
std::optional<Continuation::Row> Continuation::at_frequency(const Row& from, const Row& to,
                                                            double frequency) {
  const Bridge bridge(from.point, to.point);
  const Index n = equations_.balance_count();
  const bool up = to.point.z[n] > from.point.z[n];
  double low = 0.0;
  double high = 1.0;
  while (high - low > 1e-6) {
    const double u = 0.5 * (low + high);
    ((bridge.mix(hermite(u))[n] < frequency) == up ? low : high) = u;
  }
  VectorXd z = bridge.mix(hermite(low));
  z[n] = frequency;
  NewtonResult result = newton(equations_, kept_, Target{Quantity::kAngularFrequency, frequency},
                               options_.newton, z, near_);
  summary_.iterations += result.iterations;
  put(frequency, z);
  return row_between(bridge, z, result);
}

void Continuation::add_frequencies() {
  const Index n = equations_.balance_count();
  std::vector<double> wanted = options_.frequencies;
  std::ranges::sort(wanted);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows.push_back(rows_[i]);
    if (i + 1 == rows_.size()) break;
    const double here = rows_[i].point.z[n];
    const double there = rows_[i + 1].point.z[n];
    const auto first = std::ranges::upper_bound(wanted, std::min(here, there));
    std::vector<double> inside(first, std::ranges::lower_bound(wanted, std::max(here, there)));
    if (there < here) std::ranges::reverse(inside);
    for (const double frequency : inside) {
      std::optional<Row> row = at_frequency(rows.back(), rows_[i + 1], frequency);
      if (row) {
        rows.push_back(std::move(*row));
        report_progress(rows.back().point.along);
        continue;
      }
      warnings_.push_back(
          {"frequency_not_found", fmt::format("no point was found at the requested {}",
                                              describe({Quantity::kAngularFrequency, frequency}))});
    }
  }
  rows_ = std::move(rows);
}

}  // namespace microslip
