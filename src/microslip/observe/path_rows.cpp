// SPDX-License-Identifier: MIT
#include "microslip/observe/path_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "microslip/observe/turning_samples.hpp"

namespace microslip {
namespace {

/// The first row after a turn is this much shorter than others: the sliders of the smallest slip
/// displacement slip there.
constexpr double kShortRow = 0.25;
constexpr double kFullRowAfter = 8.0;  ///< lengths of a row from the turn
/// Rows of the largest branch: as many as a density has details.
constexpr double kRowsOfBranch = 64.0;
/// Samples that a parabola at a turn needs.
constexpr std::size_t kFewestOfTurn = 5;

/// Memory of the joint of its path: the reversals that still matter, and where the virgin curve
/// starts.
class Walk {
 public:
  Walk(PathStart start, double first) : start_(start), origin_(first), low_(first), high_(first) {}

  /// Continues to u in a direction. @return whether the stretches behind changed.
  bool move(double u, double direction) {
    bool changed = false;
    while (turns_.size() >= 2 && direction * (u - turns_[turns_.size() - 2]) > 0.0 &&
           (turns_.size() > 2 || start_ == PathStart::kVirgin)) {
      turns_.resize(turns_.size() - 2);
      changed = true;
    }
    if (start_ == PathStart::kVirgin) {
      const bool passed =
          turns_.size() == 1 && direction * (u - origin_) > std::abs(turns_.front() - origin_);
      if (passed) turns_.clear();
      return changed || passed;
    }
    const bool grows = u > high_ || u < low_;
    if (grows && !growing_) {
      turns_.clear();
      growing_ = changed = true;
    }
    low_ = std::min(low_, u);
    high_ = std::max(high_, u);
    return changed;
  }

  /// Turns at u.
  void turn(double u) {
    if (start_ == PathStart::kUnknown && growing_) {
      origin_ = 0.5 * (low_ + high_);
      turns_ = {u > origin_ ? low_ : high_, u};
      growing_ = false;
      ++group_;
      return;
    }
    turns_.push_back(u);
  }

  /// Whether the force of all sliders is known but for an offset.
  [[nodiscard]] bool known() const { return start_ == PathStart::kVirgin || !growing_; }
  [[nodiscard]] std::size_t group() const { return group_; }
  [[nodiscard]] double origin() const { return origin_; }
  [[nodiscard]] double last_turn() const { return turns_.empty() ? origin_ : turns_.back(); }

  /// The stretch to u.
  [[nodiscard]] PathStretch stretch_to(double u, double direction) const {
    if (turns_.empty()) return {direction, std::max(0.0, direction * (u - origin_))};
    return {2.0 * direction, 0.5 * std::max(0.0, direction * (u - turns_.back()))};
  }

  /// The stretches up to the last turn.
  [[nodiscard]] std::vector<PathStretch> behind() const {
    std::vector<PathStretch> all;
    for (std::size_t i = 0; i < turns_.size(); ++i) {
      const double from = i == 0 ? origin_ : turns_[i - 1];
      const double length = turns_[i] - from;
      const double sign = length > 0.0 ? 1.0 : -1.0;
      all.push_back(i == 0 ? PathStretch{sign, std::abs(length)}
                           : PathStretch{2.0 * sign, 0.5 * std::abs(length)});
    }
    return all;
  }

 private:
  PathStart start_;
  double origin_;
  double low_;
  double high_;
  std::vector<double> turns_;
  // Before the first turn nothing is known.
  bool growing_ = true;
  std::size_t group_ = 0;
};

/// Collects samples into rows.
class RowBuilder {
 public:
  RowBuilder(std::span<const double> path, std::span<const double> force, PathRows& out)
      : path_(path), force_(force), out_(out) {}

  /// Length of the rows to come, m.
  void set_length(double length) { length_ = length; }

  /// Ends the row; the next one has new stretches behind it.
  void end_stretch() {
    end_row();
    turns_.reset();
  }

  void add(std::size_t sample, double direction, const Walk& walk) {
    const double u = path_[sample];
    const double from_turn = std::abs(u - walk.last_turn());
    const double most = length_ * std::clamp(from_turn / (kFullRowAfter * length_), kShortRow, 1.0);
    if (count_ > 0 && std::abs(u - path_[row_.first]) > most) end_row();
    if (!turns_) {
      turns_ = out_.turns.size();
      out_.turns.push_back(walk.behind());
      for (const PathStretch& one : out_.turns.back()) {
        out_.reach = std::max(out_.reach, one.half_range);
      }
    }
    const PathStretch stretch = walk.stretch_to(u, direction);
    out_.reach = std::max(out_.reach, stretch.half_range);
    if (count_ == 0) {
      row_ = {};
      row_.first = sample;
      row_.group = walk.group();
      row_.turns = *turns_;
      row_.last.coefficient = stretch.coefficient;
      sum_ = 0.0;
    }
    ++count_;
    sum_ += stretch.half_range;
    out_.half_range.push_back(stretch.half_range);
    row_.displacement += u - walk.origin();
    row_.force += force_[sample];
    row_.velocity += velocity(sample);
  }

  void end_row() {
    if (count_ == 0) return;
    const auto n = static_cast<double>(count_);
    row_.count = count_;
    row_.last.half_range = sum_ / n;
    row_.displacement /= n;
    row_.force /= n;
    row_.velocity /= n;
    out_.rows.push_back(row_);
    count_ = 0;
  }

 private:
  [[nodiscard]] double velocity(std::size_t i) const {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(path_.size() - 1, i + 1);
    return (path_[after] - path_[before]) / static_cast<double>(after - before);
  }

  std::span<const double> path_;
  std::span<const double> force_;
  double length_ = 0.0;
  PathRows& out_;
  PathRow row_;
  std::size_t count_ = 0;
  double sum_ = 0.0;
  std::optional<std::size_t> turns_;
};

/// A tenth of the half ranges between turns lies below.
double tenth_of_ranges(std::span<const double> path, const std::vector<std::size_t>& turns) {
  std::vector<double> ranges;
  for (std::size_t i = 1; i < turns.size(); ++i) {
    ranges.push_back(0.5 * std::abs(path[turns[i]] - path[turns[i - 1]]));
  }
  const auto tenth = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 10);
  std::ranges::nth_element(ranges, tenth);
  return *tenth;
}

/// A turn of a path, at a sample or beside it.
struct Turn {
  std::size_t sample;  ///< the last one on the branch that ends
  double value;        ///< of the path, m
};

/// The extreme of the parabola through the samples about a turn that noise alone may have made it.
/// The extreme of the samples is beyond that of the path by the largest of their errors, and a hold
/// has many.
double smooth_turn(std::span<const double> path, std::size_t sample, double width) {
  std::size_t from = sample;
  std::size_t to = sample + 1;
  while (from > 0 && std::abs(path[from - 1] - path[sample]) <= width) --from;
  while (to < path.size() && std::abs(path[to] - path[sample]) <= width) ++to;
  const auto n = static_cast<double>(to - from);
  if (to - from < kFewestOfTurn) return path[sample];
  const double half = 0.5 * (n - 1.0);
  const double mean_square = (n + 1.0) / (3.0 * (n - 1.0));  // of t = −1 to 1 at n places
  double mean = 0.0;
  double along = 0.0;
  double curved = 0.0;
  double squares = 0.0;  // of t² − its mean
  for (std::size_t i = from; i < to; ++i) {
    const double t = static_cast<double>(i - from) / half - 1.0;
    const double bend = t * t - mean_square;
    mean += path[i] / n;
    along += t * (path[i] - path[sample]) / (n * mean_square);
    curved += bend * (path[i] - path[sample]);
    squares += bend * bend;
  }
  curved /= squares;
  const double outwards =
      2.0 * path[sample] - path[from == 0 ? 0 : from - 1] - path[to == path.size() ? to - 1 : to];
  if (curved * outwards >= 0.0) return mean;
  const double at = std::clamp(-0.5 * along / curved, -1.0, 1.0);
  return mean + along * at + curved * (at * at - mean_square);
}

/// The turn at a sample, sharp where one of the corners is beside it: the mean of the straight
/// lines through two samples on either side. What is not beyond the sample is no turn of the
/// corner.
Turn turn_at(std::span<const double> path, std::size_t sample,
             const std::vector<PathCorner>& corners, double threshold) {
  const Turn at_sample{sample, smooth_turn(path, sample, threshold)};
  if (sample < 2 || sample + 3 > path.size()) return at_sample;
  const auto place = static_cast<double>(sample);
  const auto corner = std::ranges::lower_bound(corners, place - 1.0, {}, &PathCorner::at);
  if (corner == corners.end() || corner->at >= place + 1.0) return at_sample;
  const std::size_t before = corner->at < place ? sample - 1 : sample;
  const std::size_t after = before + 1;
  if (before < 1 || after + 1 >= path.size()) return at_sample;
  const double share = corner->at - static_cast<double>(before);
  const double value = 0.5 * (path[before] + share * (path[before] - path[before - 1]) +
                              path[after] - (1.0 - share) * (path[after + 1] - path[after]));
  const double direction =
      path[sample] > path[sample - 1] || path[sample] > path[sample + 1] ? 1.0 : -1.0;
  if (direction * (value - path[sample]) < 0.0) return at_sample;
  return {before, value};
}

/// How long the rows of each branch are.
class RowLengths {
 public:
  RowLengths(std::span<const double> path, std::size_t most_rows) {
    double travel = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) travel += std::abs(path[i] - path[i - 1]);
    const auto [low, high] = std::ranges::minmax(path);
    long_ = travel / static_cast<double>(most_rows);
    short_ = std::min(long_, (high - low) / kRowsOfBranch);
  }

  /// Every so many branches have short rows, in no rhythm that a path may have: multiples of the
  /// golden section are spread evenly over (0, 1).
  [[nodiscard]] double of_branch(std::size_t branch) const {
    const double place = static_cast<double>(branch) * std::numbers::phi;
    return (place - std::floor(place)) * long_ < short_ ? short_ : long_;
  }

 private:
  double long_;
  double short_;
};

}  // namespace

std::string_view to_string(PathStart start) {
  return start == PathStart::kVirgin ? "virgin" : "unknown";
}

PathRows path_rows(std::span<const double> path, std::span<const double> force, PathStart start,
                   double threshold, std::size_t most_rows,
                   const std::vector<PathCorner>& corners) {
  PathRows out;
  const std::vector<std::size_t> turns = turning_samples(path, threshold);
  out.reversals = turns.size() - 2;
  out.shortest = tenth_of_ranges(path, turns);
  const RowLengths lengths(path, most_rows);
  RowBuilder builder(path, force, out);
  Walk walk(start, path.front());
  std::size_t next = 0;
  for (std::size_t k = 1; k < turns.size(); ++k) {
    const double direction = path[turns[k]] > path[turns[k - 1]] ? 1.0 : -1.0;
    builder.set_length(lengths.of_branch(k - 1));
    const Turn turn = turn_at(path, turns[k], corners, threshold);
    for (; next <= turn.sample; ++next) {
      if (walk.move(path[next], direction)) builder.end_stretch();
      if (walk.known()) builder.add(next, direction, walk);
    }
    builder.end_stretch();
    walk.move(turn.value, direction);
    walk.turn(turn.value);
  }
  for (PathRow& row : out.rows) row.group -= start == PathStart::kUnknown ? 1 : 0;
  out.groups = out.rows.empty() ? 0 : out.rows.back().group + 1;
  return out;
}

}  // namespace microslip
