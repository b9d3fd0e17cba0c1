// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

/// @file
/// Scatter of the levels of a campaign, and thresholds for reporting differences. Internal to
/// workflow.

namespace microslip {

/// Number of standard deviations from which a difference is reported.
inline constexpr double kSignificant = 3.0;
/// Resolution of a resonance, relative.
inline constexpr double kLeastDifference = 1e-4;

/// v̄; NaN of none.
[[nodiscard]] inline double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// √(Σv²/n); NaN of none.
[[nodiscard]] inline double rms_of(const std::vector<double>& values) {
  const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Σ(v − v̄)².
[[nodiscard]] inline double squares_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum;
}

/// s² of values that scatter within groups: Σ(v − v̄)²/(n − G) over the n values of G groups, v̄ of
/// each by itself.
class PooledScatter {
 public:
  /// The values of a group; none counts for nothing.
  void add(const std::vector<double>& values) {
    if (values.empty()) return;
    squares_ += squares_of(values);
    freedom_ += values.size() - 1;
  }

  /// Whether a group has two values.
  [[nodiscard]] bool known() const { return freedom_ > 0; }
  /// s²; NaN where that is not known.
  [[nodiscard]] double variance() const { return squares_ / static_cast<double>(freedom_); }

 private:
  double squares_ = 0.0;
  std::size_t freedom_ = 0;
};

}  // namespace microslip
