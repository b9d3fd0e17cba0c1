// SPDX-License-Identifier: MIT
#include "microslip/observe/record_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "microslip/observe/turning_samples.hpp"

namespace microslip {
namespace {

/// Ranges within this share of each other are the same, beside the noise;
constexpr double kAlike = 1e-4;
/// and those within this share close again, where no larger cycle contains them.
constexpr double kAsLarge = 0.03;
/// The range before them may lack less: where a path goes beyond its last turns, the joint leaves
/// the branch for the one outside, an error of first order.
constexpr double kGrows = 5e-3;
/// A record that begins at a turn of at least this share of its whole range was cut out of similar
/// cycles, where its force comes back to this share of its range beside the noise.
constexpr double kLoopAlone = 0.9;
constexpr double kForceReturns = 0.01;
/// A cycle is flagged where its gap exceeds this share, and so many deviations.
constexpr double kMostGap = 0.02;
constexpr double kGapDeviations = 5.0;
/// Fewer samples show no shape; of n, chords make D too small by 6.6/n² [polygon in an ellipse].
constexpr std::size_t kFewestPoints = 12;
constexpr std::size_t kEnoughPoints = 40;
/// D of less than so many deviations is below noise.
constexpr double kResolved = 3.0;
/// Noise below this share of the range of the signal is that of digits, or of its own kinks.
constexpr double kLeastNoise = 2e-5;
/// Share of a branch from which its tangent at the tip is computed.
constexpr double kTipShare = 0.125;
/// The mean of a cycle moves by more than this share of its amplitude, or by what changes its D by
/// this share, so many times in a row; each time by so many deviations.
constexpr double kMeanMoved = 0.02;
constexpr double kDissipationMoved = 0.02;
constexpr std::size_t kMovesInARow = 2;
constexpr double kMoveDeviations = 2.0;

double range_of(std::span<const double> values) {
  const auto [low, high] = std::ranges::minmax(values);
  return high - low;
}

double noise_or_none(double noise, std::span<const double> values) {
  return noise > kLeastNoise * range_of(values) ? noise : 0.0;
}

/// A place of a loop.
struct Vertex {
  double displacement;
  double force;
  double smooth_force;  // without most of its noise
};

/// A loop as a closed polygon: down or up to the turn, and back.
struct Loop {
  std::vector<Vertex> vertices;  // the last is beside the first
  std::size_t turn = 0;          // index of b
};

/// √(1 − x²) and its integral.
double half_circle(double x) { return std::sqrt(std::max(0.0, 1.0 - x * x)); }
double under_half_circle(double x) { return 0.5 * (x * half_circle(x) + std::asin(x)); }

/// A loop between −1 and 1, x = (u − ū)/A, and S = √(1 − x²) along it. Segment i goes from vertex i
/// to the next, the last one back to the first. With it ∮ F cos θ dθ is ∫ F dS along the first
/// branch less that along the second; and of a force that is straight in u between vertices
/// ∫ F dS = [F S] − ΔF S̄ over a segment, S̄ the mean of S over it.
class UnitLoop {
 public:
  UnitLoop(const Loop& loop, double mean, double amplitude)
      : turn_(loop.turn), down_(loop.vertices[loop.turn].displacement < mean ? 1.0 : -1.0) {
    for (const Vertex& vertex : loop.vertices) {
      place_.push_back(std::clamp((vertex.displacement - mean) / amplitude, -1.0, 1.0));
      height_.push_back(half_circle(place_.back()));
    }
    for (std::size_t i = 0; i < size(); ++i) mean_height_.push_back(mean_between(i));
  }

  [[nodiscard]] std::size_t size() const { return place_.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % size(); }
  [[nodiscard]] double place(std::size_t i) const { return place_[i]; }    ///< x
  [[nodiscard]] double height(std::size_t i) const { return height_[i]; }  ///< S
  /// S̄ of segment i.
  [[nodiscard]] double mean_height(std::size_t i) const { return mean_height_[i]; }
  /// 1 along the branch that goes down, −1 along the other.
  [[nodiscard]] double sign(std::size_t i) const { return (i < turn_ ? 1.0 : -1.0) * down_; }
  /// Whether a vertex is at a turn, where x stays what it is; beside the rounding of x.
  [[nodiscard]] bool at_turn(std::size_t i) const {
    constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
    return std::abs(place_[i]) >= 1.0 - kRounding;
  }

  /// ∂S̄/∂x of segment i by the place of vertex i, and by that of the next.
  [[nodiscard]] double change_by_first(std::size_t i) const {
    return change(i, mean_height_[i] - height_[i]);
  }
  [[nodiscard]] double change_by_next(std::size_t i) const {
    return change(i, height_[next(i)] - mean_height_[i]);
  }

 private:
  /// Differences of close places would cancel.
  static constexpr double kClose = 1e-7;

  [[nodiscard]] double width(std::size_t i) const { return place_[next(i)] - place_[i]; }

  [[nodiscard]] double mean_between(std::size_t i) const {
    if (std::abs(width(i)) <= kClose) return half_circle(0.5 * (place_[i] + place_[next(i)]));
    return (under_half_circle(place_[next(i)]) - under_half_circle(place_[i])) / width(i);
  }

  /// For close places half of S′ = −x/S, at a turn that of a place so close to it: S′ is unbounded
  /// there, but the mean of S between two places that near does not change by more.
  [[nodiscard]] double change(std::size_t i, double by) const {
    if (std::abs(width(i)) > kClose) return by / width(i);
    return -0.5 * place_[i] / std::max(height_[i], half_circle(1.0 - kClose));
  }

  std::size_t turn_;
  double down_;
  std::vector<double> place_;
  std::vector<double> height_;
  std::vector<double> mean_height_;
};

/// Derivatives of D and k_eq of a loop.
struct LoopDerivatives {
  std::vector<double> dissipation;
  std::vector<double> secant;
};

/// Derivatives by the forces of its vertices, of which D and k_eq are sums with these weights, m
/// and 1/m.
LoopDerivatives by_force(const Loop& loop, const UnitLoop& unit, double amplitude) {
  const std::size_t n = unit.size();
  LoopDerivatives weights{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = unit.next(i);
    const double step = loop.vertices[next].displacement - loop.vertices[i].displacement;
    weights.dissipation[i] += 0.5 * step;
    weights.dissipation[next] += 0.5 * step;
    const double sign = unit.sign(i) / (std::numbers::pi * amplitude);
    weights.secant[i] += sign * (unit.mean_height(i) - unit.height(i));
    weights.secant[next] += sign * (unit.height(next) - unit.mean_height(i));
  }
  return weights;
}

/// Derivatives by the displacements of its vertices, N and N/m². An error of u acts by the slope
/// that the force has there, which is that of the stuck joint behind a turn, however low k_eq is;
/// and one of a turn moves A and ū.
/// @param secant  k_eq.
LoopDerivatives by_displacement(const Loop& loop, const UnitLoop& unit, double amplitude,
                                double secant) {
  const std::size_t n = unit.size();
  LoopDerivatives slopes{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = unit.next(i);
    const double rise = loop.vertices[next].smooth_force - loop.vertices[i].smooth_force;
    slopes.dissipation[i] -= 0.5 * rise;
    slopes.dissipation[next] -= 0.5 * rise;
    const double by = -unit.sign(i) * rise / (std::numbers::pi * amplitude * amplitude);
    slopes.secant[i] += by * unit.change_by_first(i);
    slopes.secant[next] += by * unit.change_by_next(i);
  }
  double of_mean = 0.0;  // ∂k_eq/∂ū
  double of_amplitude = -secant / amplitude;
  for (std::size_t i = 0; i < n; ++i) {
    if (unit.at_turn(i)) {
      slopes.secant[i] = 0.0;
      continue;
    }
    of_mean -= slopes.secant[i];
    of_amplitude -= unit.place(i) * slopes.secant[i];
  }
  for (const std::size_t i : {std::size_t{0}, loop.turn}) {
    slopes.secant[i] = 0.5 * (of_mean + unit.place(i) * of_amplitude);
  }
  return slopes;
}

double norm(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum);
}

/// √(Σ(mean of `length` values in a row)²), over all that contain one of them: the norm for
/// errors that a low-pass of that length has left of independent ones.
double norm_of_means(const std::vector<double>& values, std::size_t length) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i + 1 < values.size() + length; ++i) {
    if (i < values.size()) sum += values[i];
    if (i >= length) sum -= values[i - length];
    squares += sum * sum;
  }
  return std::sqrt(squares) / static_cast<double>(length);
}

/// Follows a path and removes cycles from it as they close.
class CycleFinder {
 public:
  explicit CycleFinder(const RecordEvidence& evidence)
      : path_(evidence.path().displacement),
        force_(evidence.measured().force),
        path_left_(evidence.path().left),
        smooth_force_(smooth_path(force_)),
        whole_(range_of(path_)),
        same_(evidence.path().smallest_turn()),
        skip_(path_.size(), 0),
        inner_(path_.size(), 0) {
    found_.force_noise = noise_or_none(smooth_force_.noise, force_);
    found_.path_noise = noise_or_none(evidence.path().noise, path_);
    for (const std::size_t turn : turning_samples(path_, same_)) {
      turns_.push_back(turn);
      while (take_closed()) {
      }
    }
    take_nearly_closed();
  }

  RecordCycles take() && { return std::move(found_); }

 private:
  [[nodiscard]] double range(std::size_t i) const {
    return std::abs(path_[turns_[i]] - path_[turns_[i + 1]]);
  }

  /// Removes the cycle that the last turn closes. @return false where it closes none.
  bool take_closed() {
    const std::size_t n = turns_.size();
    if (n < 4) return false;
    const double own = range(n - 3);
    const double least = (1.0 - kAlike) * own - same_;
    if (range(n - 4) < least || range(n - 2) < least) return false;
    const std::size_t a = turns_[n - 3];
    const std::size_t b = turns_[n - 2];
    std::size_t last = turns_[n - 1];
    RecordCycle cycle = measure(loop_of(a, b, last), a, b, last);
    cycle.inner = inner_of(a, last);
    skip_[a] = last;
    inner_[a] = cycle.inner + 1;
    keep(std::move(cycle));
    turns_[n - 3] = turns_[n - 1];
    turns_.resize(n - 2);
    return true;
  }

  /// Keeps cycles of the remaining turns, whose ranges rise and then fall, that are nearly as large
  /// as their neighbours: no larger cycle will close around them.
  void take_nearly_closed() {
    for (std::size_t i = 0; i + 2 < turns_.size(); ++i) {
      const double as_large = (1.0 - kAsLarge) * range(i);
      if (range(i + 1) < as_large) continue;
      std::size_t last = turns_[i + 2];
      const Loop loop = loop_of(turns_[i], turns_[i + 1], last);
      RecordCycle cycle = measure(loop, turns_[i], turns_[i + 1], last);
      const bool cut_out = i == 0 && as_large > kLoopAlone * whole_ && force_returns(cycle, loop);
      if (!cut_out && (i == 0 || range(i - 1) < (1.0 - kGrows) * range(i))) continue;
      cycle.inner = inner_of(cycle.first, last);
      if (cut_out && turns_.size() == 3) cycle.flags.emplace_back(kOneLoop);
      keep(std::move(cycle));
      ++i;  // the return is no branch of another cycle
    }
  }

  /// The vertices of a cycle without closed cycles inside.
  /// @param last  the next turn; becomes the end of the cycle.
  [[nodiscard]] Loop loop_of(std::size_t a, std::size_t b, std::size_t& last) const {
    Loop loop;
    const double start = path_[a];
    const double up = path_[a] > path_[b] ? 1.0 : -1.0;
    for (std::size_t i = a; i < b; i = next(i)) loop.vertices.push_back(vertex(i));
    loop.turn = loop.vertices.size();
    std::size_t before = b;
    for (std::size_t i = b; i <= last; before = i, i = next(i)) {
      if (up * (path_[i] - start) >= 0.0) {
        loop.vertices.push_back(vertex_between(before, i, start));
        last = i;
        break;
      }
      loop.vertices.push_back(vertex(i));
    }
    return loop;
  }

  [[nodiscard]] Vertex vertex(std::size_t i) const {
    return {path_[i], force_[i], smooth_force_.displacement[i]};
  }

  /// Force on the straight line between two samples, at a displacement.
  [[nodiscard]] Vertex vertex_between(std::size_t i, std::size_t k, double displacement) const {
    const double share = (displacement - path_[i]) / (path_[k] - path_[i]);
    const auto at = [&](const std::vector<double>& values) {
      return values[i] + share * (values[k] - values[i]);
    };
    return {displacement, at(force_), at(smooth_force_.displacement)};
  }

  [[nodiscard]] std::size_t next(std::size_t i) const { return skip_[i] > i ? skip_[i] : i + 1; }

  [[nodiscard]] std::size_t inner_of(std::size_t a, std::size_t last) const {
    std::size_t count = 0;
    for (std::size_t i = a; i < last; i = next(i)) count += skip_[i] > i ? inner_[i] : 0;
    return count;
  }

  [[nodiscard]] RecordCycle measure(const Loop& loop, std::size_t a, std::size_t b,
                                    std::size_t last) const {
    RecordCycle cycle;
    cycle.first = a;
    cycle.turn = b;
    cycle.last = last;
    cycle.points = loop.vertices.size();
    cycle.amplitude = 0.5 * std::abs(path_[a] - path_[b]);
    cycle.mean_displacement = 0.5 * (path_[a] + path_[b]);
    cycle.mean_force = 0.5 * (force_[a] + force_[b]);
    const UnitLoop unit(loop, cycle.mean_displacement, cycle.amplitude);
    const LoopDerivatives weights = by_force(loop, unit, cycle.amplitude);
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const double force = loop.vertices[i].force - cycle.mean_force;
      cycle.dissipation += weights.dissipation[i] * force;
      cycle.secant_stiffness += weights.secant[i] * force;
    }
    const LoopDerivatives slopes =
        by_displacement(loop, unit, cycle.amplitude, cycle.secant_stiffness);
    cycle.amplitude_std = found_.path_noise > 0.0 ? path_left_ / std::numbers::sqrt2 : 0.0;
    cycle.dissipation_std = deviation(weights.dissipation, slopes.dissipation);
    cycle.secant_stiffness_std = deviation(weights.secant, slopes.secant);
    cycle.gap = gap_of(loop);
    return cycle;
  }

  /// Deviation of a sum of independent errors of force and path; of the path those that its
  /// smoothing left.
  [[nodiscard]] double deviation(const std::vector<double>& of_force,
                                 const std::vector<double>& of_path) const {
    if (!(found_.path_noise > 0.0)) return found_.force_noise * norm(of_force);
    const double samples = std::pow(found_.path_noise / path_left_, 2);  // that it took together
    const double longest = static_cast<double>(path_.size());
    const auto length = static_cast<std::size_t>(std::clamp(std::round(samples), 1.0, longest));
    return std::hypot(found_.force_noise * norm(of_force),
                      found_.path_noise * norm_of_means(of_path, length));
  }

  /// Gap of the force at a, extrapolated along the tangent where the path ends short of it.
  [[nodiscard]] static double gap_of(const Loop& loop) {
    const Vertex& start = loop.vertices.front();
    const Vertex& end = loop.vertices.back();
    const double lacks = end.displacement - start.displacement;
    return end.force - start.force - (lacks == 0.0 ? 0.0 : last_slope(loop) * lacks);
  }

  /// Chord of the last eighth of the second branch.
  [[nodiscard]] static double last_slope(const Loop& loop) {
    const Vertex& end = loop.vertices.back();
    const double whole = end.displacement - loop.vertices[loop.turn].displacement;
    std::size_t i = loop.vertices.size() - 1;
    while (i > loop.turn &&
           (end.displacement - loop.vertices[i].displacement) / whole < kTipShare) {
      --i;
    }
    const Vertex& from = loop.vertices[i];
    return (end.force - from.force) / (end.displacement - from.displacement);
  }

  [[nodiscard]] static double force_range(const Loop& loop) {
    const auto [low, high] = std::ranges::minmax_element(loop.vertices, {}, &Vertex::force);
    return high->force - low->force;
  }

  /// Deviation of gap_of().
  [[nodiscard]] double gap_noise(const RecordCycle& cycle) const {
    return std::numbers::sqrt2 *
           std::hypot(found_.force_noise, cycle.secant_stiffness * found_.path_noise);
  }

  [[nodiscard]] bool force_returns(const RecordCycle& cycle, const Loop& loop) const {
    return std::abs(cycle.gap) < kForceReturns * force_range(loop) + 2.0 * gap_noise(cycle);
  }

  void keep(RecordCycle cycle) {
    if (cycle.points < kFewestPoints) {
      ++found_.coarse;
      return;
    }
    if (cycle.points < kEnoughPoints) cycle.flags.emplace_back(kFewSamples);
    const double most =
        std::max(kMostGap * 2.0 * cycle.amplitude * std::abs(cycle.secant_stiffness),
                 kGapDeviations * gap_noise(cycle));
    if (std::abs(cycle.gap) > most) cycle.flags.emplace_back(kNotClosed);
    found_.cycles.push_back(std::move(cycle));
  }

  const std::vector<double>& path_;
  const std::vector<double>& force_;
  double path_left_;
  SmoothedPath smooth_force_;
  double whole_;  // range of the path
  double same_;   // places that are no further apart are the same
  std::vector<std::size_t> turns_;
  std::vector<std::size_t> skip_;   // of the first sample of a closed cycle: its last
  std::vector<std::size_t> inner_;  // of the same: itself and those inside
  RecordCycles found_;
};

/// Removes the cycles below noise.
void leave_unresolved_out(RecordCycles& found) {
  for (const RecordCycle& cycle : found.cycles) {
    if (cycle.has_flag(kNotClosed) || cycle.dissipation >= kResolved * cycle.dissipation_std) {
      continue;
    }
    found.smallest = std::max(found.smallest, cycle.amplitude);
  }
  const auto out = [&](const RecordCycle& cycle) {
    return cycle.amplitude <= found.smallest || !(cycle.dissipation > 0.0) ||
           !(cycle.secant_stiffness > 0.0);
  };
  found.unresolved = std::erase_if(found.cycles, out);
}

/// The least move of the mean that matters, m. Where it is that of the sensor and not of the joint,
/// a cycle ends this much short of its turn or beyond it: D misses the force there, about k_eq A,
/// times the move, which of a slim loop is a large share.
double least_move(const RecordCycle& cycle) {
  const double by_loss =
      kDissipationMoved * cycle.dissipation / (cycle.secant_stiffness * cycle.amplitude);
  const double deviation = std::numbers::sqrt2 * cycle.amplitude_std;  // of two means
  return std::min(kMeanMoved * cycle.amplitude, std::max(by_loss, kMoveDeviations * deviation));
}

/// Whether the mean moves from one cycle to the next, which begins where that ends and is as large.
/// @return −1, 0 or 1.
int moved(const RecordCycle& before, const RecordCycle& cycle) {
  const bool alike = std::abs(cycle.amplitude - before.amplitude) < kAsLarge * cycle.amplitude;
  const bool next = cycle.first >= before.last && cycle.first + before.first < 2 * before.last;
  if (!alike || !next) return 0;
  const double by = cycle.mean_displacement - before.mean_displacement;
  if (std::abs(by) < least_move(cycle)) return 0;
  return by > 0.0 ? 1 : -1;
}

void flag_moving_means(std::vector<RecordCycle>& cycles) {
  std::size_t in_a_row = 0;
  int direction = 0;
  for (std::size_t i = 1; i < cycles.size(); ++i) {
    const int now = moved(cycles[i - 1], cycles[i]);
    in_a_row = now == 0 ? 0 : now == direction ? in_a_row + 1 : 1;
    direction = now;
    if (in_a_row < kMovesInARow) continue;
    // The first of them moved as well.
    const std::size_t from = in_a_row == kMovesInARow ? i - kMovesInARow : i;
    for (std::size_t j = from; j <= i; ++j) {
      if (!cycles[j].has_flag(kMeanMoves)) cycles[j].flags.emplace_back(kMeanMoves);
    }
  }
}

std::vector<double> column_of(std::span<const RecordCycles> records, double RecordCycle::*value) {
  std::vector<double> values;
  for (const RecordCycles& record : records) {
    for (const RecordCycle& cycle : record.cycles) values.push_back(cycle.*value);
  }
  return values;
}

bool all_have(std::span<const RecordCycles> records, double RecordCycles::*noise) {
  return std::ranges::all_of(records, [&](const RecordCycles& one) { return one.*noise > 0.0; });
}

}  // namespace

bool RecordCycle::has_flag(std::string_view code) const {
  return std::ranges::find(flags, code) != flags.end();
}

RecordCycles record_cycles(const RecordEvidence& evidence) {
  RecordCycles found = CycleFinder(evidence).take();
  leave_unresolved_out(found);
  std::ranges::sort(found.cycles, {}, &RecordCycle::first);
  flag_moving_means(found.cycles);
  return found;
}

Levels levels_of_cycles(std::span<const RecordCycles> records) {
  Levels levels;
  levels.amplitude = column_of(records, &RecordCycle::amplitude);
  levels.dissipation = column_of(records, &RecordCycle::dissipation);
  levels.secant_stiffness = column_of(records, &RecordCycle::secant_stiffness);
  const bool of_path = all_have(records, &RecordCycles::path_noise);
  if (of_path) levels.amplitude_std = column_of(records, &RecordCycle::amplitude_std);
  if (!of_path && !all_have(records, &RecordCycles::force_noise)) return levels;
  levels.dissipation_std = column_of(records, &RecordCycle::dissipation_std);
  levels.secant_stiffness_std = column_of(records, &RecordCycle::secant_stiffness_std);
  return levels;
}

}  // namespace microslip
