// SPDX-License-Identifier: MIT
#include "microslip/observe/path_corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/observe/path_noise.hpp"

namespace microslip {
namespace {

/// Half widths of the windows in samples or their means; the narrow one is for samples alone.
constexpr std::array<std::size_t, 2> kWindows = {4, 8};
/// A corner explains more than a smooth path by so many variances: twice the logarithm of the
/// number of windows of a million samples, and a margin.
constexpr double kSignificant = 40.0;
/// In the window in which it is seen it leaves less than this share of what a smooth path does.
constexpr double kClearly = 1.0 / 3.0;
/// In the end it leaves the noise, to this factor of the variance, or this share and, as root of
/// the sum of squares, less than this share of what the velocity changes in a sample: a corner that
/// is rounded over a sample leaves a quarter of it.
constexpr double kNoiseAlone = 2.0;
constexpr double kShareLeft = 1e-2;
constexpr double kSharp = 0.05;
/// Samples on each side of a corner that its place is found from.
constexpr std::size_t kFewestBeside = 4;
constexpr int kSteps = 6;
/// Windows see one corner each. Those beside it are searched for once more without it; no corners
/// are nearer to each other than so many samples.
constexpr int kSearches = 3;
constexpr double kApart = 5.0;
constexpr double kLeastReach = 16.0;
/// Share of its reach over which the part of a corner is not faded.
constexpr double kNotFaded = 0.25;

/// What a corner at the centre of a window explains of its even part, and what a smooth path does.
class Window {
 public:
  explicit Window(std::size_t half) : half_(half) {
    constant_ = orthogonal([](double) { return 1.0; }, {});
    square_ = orthogonal([](double t) { return t * t; }, {&constant_});
    corner_ = orthogonal([](double t) { return t; }, {&constant_, &square_});
    fourth_ = orthogonal([](double t) { return t * t * t * t; }, {&constant_, &square_});
  }

  [[nodiscard]] std::size_t half() const { return half_; }

  /// By how much the sum of squares is smaller with a corner than with a smooth path; 0 where that
  /// is not clear. @param values  those of the window begin at `centre` − half.
  [[nodiscard]] double excess(std::span<const double> values, std::size_t centre) const {
    double left = 0.0;
    double on_constant = 0.0;
    double on_square = 0.0;
    double on_corner = 0.0;
    double on_fourth = 0.0;
    const double middle = values[centre];
    for (std::size_t t = 0; t <= half_; ++t) {
      const double even = 0.5 * (values[centre + t] + values[centre - t]) - middle;
      const double weighted = weight(t) * even;
      left += weighted * even;
      on_constant += weighted * constant_[t];
      on_square += weighted * square_[t];
      on_corner += weighted * corner_[t];
      on_fourth += weighted * fourth_[t];
    }
    left -= on_constant * on_constant + on_square * on_square;
    const double with_corner = left - on_corner * on_corner;
    const double smooth = left - on_fourth * on_fourth;
    return with_corner < kClearly * smooth ? smooth - with_corner : 0.0;
  }

 private:
  /// Samples at t and −t are taken together.
  [[nodiscard]] static double weight(std::size_t t) { return t == 0 ? 1.0 : 2.0; }

  template <typename Function>
  [[nodiscard]] std::vector<double> orthogonal(
      const Function& function, const std::vector<const std::vector<double>*>& others) const {
    std::vector<double> values;
    for (std::size_t t = 0; t <= half_; ++t) {
      values.push_back(function(static_cast<double>(t) / static_cast<double>(half_)));
    }
    const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
      double sum = 0.0;
      for (std::size_t t = 0; t < a.size(); ++t) sum += weight(t) * a[t] * b[t];
      return sum;
    };
    for (const std::vector<double>* other : others) {
      const double share = product(values, *other);
      for (std::size_t t = 0; t < values.size(); ++t) values[t] -= share * (*other)[t];
    }
    const double norm = std::sqrt(product(values, values));
    for (double& value : values) value /= norm;
    return values;
  }

  std::size_t half_;
  std::vector<double> constant_;
  std::vector<double> square_;
  std::vector<double> corner_;
  std::vector<double> fourth_;
};

/// Whether no place of sorted ones is so near.
bool is_free(const std::vector<double>& taken, double at, double apart) {
  const auto next = std::ranges::lower_bound(taken, at);
  return (next == taken.end() || *next - at > apart) &&
         (next == taken.begin() || at - *(next - 1) > apart);
}

/// Places where a corner is seen, in samples; `taken` has those that were seen in narrower windows.
void search(std::span<const double> values, double per_value, double variance, const Window& window,
            std::vector<double>& taken) {
  const std::size_t half = window.half();
  if (values.size() <= 2 * half) return;
  std::vector<double> excess(values.size(), 0.0);
  for (std::size_t i = half; i + half < values.size(); ++i) {
    const double found = window.excess(values, i);
    if (found > kSignificant * variance) excess[i] = found;
  }
  const double apart = static_cast<double>(half + 1) * per_value;
  std::vector<double> seen;
  for (std::size_t i = half; i + half < values.size(); ++i) {
    if (excess[i] == 0.0) continue;
    // The first of equal ones: midway between two samples a corner explains as much at either.
    const auto here = excess.begin() + static_cast<std::ptrdiff_t>(i);
    const auto reach = static_cast<std::ptrdiff_t>(half);
    if (std::max_element(here - reach, here + reach + 1) != here) continue;
    const double at = (static_cast<double>(i) + 0.5) * per_value - 0.5;
    if (is_free(taken, at, apart)) seen.push_back(at);
  }
  const auto middle = static_cast<std::ptrdiff_t>(taken.size());
  taken.insert(taken.end(), seen.begin(), seen.end());
  std::inplace_merge(taken.begin(), taken.begin() + middle, taken.end());
}

std::vector<double> means_of_two(const std::vector<double>& values) {
  std::vector<double> means;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
    means.push_back(0.5 * (values[i] + values[i + 1]));
  }
  return means;
}

std::vector<double> corners_seen(std::span<const double> path, double noise) {
  std::vector<double> seen;
  std::vector<double> values(path.begin(), path.end());
  search(values, 1.0, noise * noise, Window(kWindows.front()), seen);
  const Window window(kWindows.back());
  double per_value = 1.0;
  while (values.size() > 2 * window.half()) {
    search(values, per_value, noise * noise / per_value, window, seen);
    values = means_of_two(values);
    per_value *= 2.0;
  }
  return seen;
}

/// Least squares of a window of samples.
struct Fitted {
  Eigen::VectorXd coefficients;
  double left = 0.0;  ///< sum of squares
};

template <typename Row>
Fitted fit(std::span<const double> path, std::size_t from, std::size_t to, Eigen::Index columns,
           const Row& row) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd moment = Eigen::VectorXd::Zero(columns);
  Eigen::VectorXd one(columns);
  const double middle = path[(from + to) / 2];
  for (std::size_t i = from; i < to; ++i) {
    row(static_cast<double>(i), one);
    gram += one * one.transpose();
    moment += one * (path[i] - middle);
  }
  Fitted found;
  found.coefficients = Eigen::LDLT<Eigen::MatrixXd>(gram).solve(moment);
  for (std::size_t i = from; i < to; ++i) {
    row(static_cast<double>(i), one);
    const double left = path[i] - middle - one.dot(found.coefficients);
    found.left += left * left;
  }
  return found;
}

/// The corner near `at` by the samples of a window, where there is one.
std::optional<PathCorner> corner_of(std::span<const double> path, double at, std::size_t from,
                                    std::size_t to, double variance) {
  const double centre = 0.5 * static_cast<double>(from + to - 1);
  const double half = 0.5 * static_cast<double>(to - from);
  const auto powers = [&](double i, Eigen::Index count, Eigen::VectorXd& one) {
    double power = 1.0;
    for (Eigen::Index j = 0; j < count; ++j, power *= (i - centre) / half) one(j) = power;
  };
  const double low = static_cast<double>(from) + 1.0;
  const double high = static_cast<double>(to) - 2.0;
  Fitted with;
  // |t − at| is linear in a change of `at`, but for samples that change sides.
  for (int step = 0; step < kSteps; ++step) {
    with = fit(path, from, to, 6, [&](double i, Eigen::VectorXd& one) {
      powers(i, 4, one);
      one(4) = std::abs(i - at) / half;
      one(5) = i > at ? 1.0 : -1.0;
    });
    const double by = -with.coefficients(5) * half / with.coefficients(4);
    if (!std::isfinite(by)) return {};
    at = std::clamp(at + by, low, high);
    if (std::abs(by) < 1e-9) break;
  }
  with = fit(path, from, to, 5, [&](double i, Eigen::VectorXd& one) {
    powers(i, 4, one);
    one(4) = std::abs(i - at) / half;
  });
  const Fitted smooth =
      fit(path, from, to, 6, [&](double i, Eigen::VectorXd& one) { powers(i, 6, one); });
  const double freedom = static_cast<double>(to - from) - 6.0;
  const double change = 2.0 * with.coefficients(4) / half;
  const bool sharp = with.left <= kSharp * change * kSharp * change;
  const bool explained = with.left <= kNoiseAlone * variance * std::max(freedom, 1.0) ||
                         (sharp && with.left <= kShareLeft * smooth.left);
  if (!explained || smooth.left - with.left <= kSignificant * variance) return {};
  return PathCorner{at, change};
}

/// The corner near `at` by as many samples as follow its model, up to its neighbours.
std::optional<PathCorner> refined(std::span<const double> path, double at, std::size_t first,
                                  std::size_t last, double variance) {
  const auto place = static_cast<std::size_t>(std::max(0.0, std::round(at)));
  std::size_t before = place - first;
  std::size_t after = last - place;
  while (before >= kFewestBeside && after >= kFewestBeside) {
    const auto found = corner_of(path, at, place - before, place + after + 1, variance);
    if (found) return found;
    const std::size_t longer = std::max(before, after);
    if (longer <= kFewestBeside) break;
    const std::size_t next = std::max(kFewestBeside, longer / 2);
    before = std::min(before, next);
    after = std::min(after, next);
  }
  return {};
}

/// Corners in order. Two that moved to one place are one: a window that reaches over a corner is
/// drawn to it.
std::vector<PathCorner> set_apart(std::vector<PathCorner> corners) {
  std::ranges::sort(corners, {}, &PathCorner::at);
  const auto alike = std::ranges::unique(
      corners,
      [](const PathCorner& one, const PathCorner& next) { return next.at - one.at <= kApart; });
  corners.erase(alike.begin(), alike.end());
  return corners;
}

/// Those of the places where there are corners.
std::vector<PathCorner> refined_corners(std::span<const double> path,
                                        const std::vector<double>& seen, double variance) {
  std::vector<PathCorner> corners;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const std::size_t first = k == 0 ? 0 : static_cast<std::size_t>(seen[k - 1] + 1.5);
    const std::size_t last =
        k + 1 == seen.size() ? path.size() - 1 : static_cast<std::size_t>(seen[k + 1] - 0.5);
    if (const auto corner = refined(path, seen[k], first, last, variance)) {
      corners.push_back(*corner);
    }
  }
  return set_apart(std::move(corners));
}

/// A path less the change of its velocity at each corner: change·t behind it.
std::vector<double> without(std::span<const double> path, const std::vector<PathCorner>& corners) {
  std::vector<double> rest(path.begin(), path.end());
  double slope = 0.0;
  double offset = 0.0;
  auto next = corners.begin();
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto at = static_cast<double>(i);
    for (; next != corners.end() && next->at < at; ++next) {
      slope += next->change;
      offset -= next->change * next->at;
    }
    rest[i] -= offset + slope * at;
  }
  return rest;
}

}  // namespace

double PathCorner::value(double t, double reach) const {
  const double share = std::abs(t) / reach;
  if (share >= 1.0) return 0.0;
  const double whole = 0.5 * change * std::abs(t);
  if (share <= kNotFaded) return whole;
  const double faded = (share - kNotFaded) / (1.0 - kNotFaded);
  // The smooth step of which derivatives up to the third vanish at both ends.
  const double step =
      faded * faded * faded * faded * (35.0 + faded * (-84.0 + faded * (70.0 - 20.0 * faded)));
  return whole * (1.0 - step);
}

std::vector<PathCorner> path_corners(std::span<const double> path) {
  const double noise = noise_of_path(path);
  std::vector<double> seen;
  std::vector<double> rest(path.begin(), path.end());
  std::vector<PathCorner> corners;
  for (int search = 0; search < kSearches; ++search) {
    for (const double at : corners_seen(rest, noise)) {
      if (is_free(seen, at, kApart)) seen.insert(std::ranges::lower_bound(seen, at), at);
    }
    const std::vector<PathCorner> found = refined_corners(path, seen, noise * noise);
    if (found.size() <= corners.size()) break;
    // What is none does not narrow the windows of the others.
    seen.clear();
    for (const PathCorner& corner : found) seen.push_back(corner.at);
    corners = refined_corners(path, seen, noise * noise);
    rest = without(path, corners);
  }
  return corners;
}

std::vector<double> reach_of_corners(const std::vector<PathCorner>& corners, double size) {
  std::vector<double> reach(corners.size(), size);
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const double apart = corners[k].at - corners[k - 1].at;
    reach[k - 1] = std::max(kLeastReach, std::min(reach[k - 1], apart));
    reach[k] = std::max(kLeastReach, std::min(reach[k], apart));
  }
  return reach;
}

}  // namespace microslip
