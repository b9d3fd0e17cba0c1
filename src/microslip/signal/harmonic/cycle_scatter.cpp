// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/cycle_scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Signals = std::span<const std::span<const double>>;

constexpr double kPointsPerUnknown = 2.0;
/// A record of whole cycles must not lose its last one by rounding.
constexpr double kCycleRounding = 1e-9;
constexpr double kLargestCorrelation = 0.9;
constexpr std::size_t kLeastValues = 4;

void check(const Axis& axis, Signals signals, const FourierFit& fit,
           const CycleSeriesOptions& options) {
  const auto require_positive = [](std::string_view what, double value) {
    if (value > 0.0 && std::isfinite(value)) return;
    throw InputError(what, value, "must be above 0 and finite");
  };
  require_positive("omega of the fit", fit.omega);
  require_positive("cycles of the fit", fit.cycles);
  if (axis.even()) require_positive("step of the axis", axis.step);
  if (fit.points < 2) {
    throw InputError("points of the fit", static_cast<double>(fit.points), "must be at least 2");
  }
  if (options.order < 1) throw InputError("order", options.order, "must be at least 1");
  if (signals.size() != fit.series.size()) {
    throw InputError("number of signals", static_cast<double>(signals.size()),
                     fmt::format("must be {}, that of the fit", fit.series.size()));
  }
  for (const std::span<const double> signal : signals) {
    if (signal.size() == fit.points) continue;
    throw InputError("length of a signal", static_cast<double>(signal.size()),
                     fmt::format("must be {}, that of the fit", fit.points));
  }
  if (!axis.even() && axis.values.size() != fit.points) {
    throw InputError("number of times", static_cast<double>(axis.values.size()),
                     fmt::format("must be {}, that of the fit", fit.points));
  }
}

/// Time of the end of the last point's share of the record.
double end_of(const Axis& axis, std::size_t points) {
  if (axis.even()) return axis.at(points - 1) + axis.step;
  const double length = axis.values.back() - axis.values.front();
  return axis.values.back() + length / static_cast<double>(points - 1);
}

/// First point at or after a time, rounding allowed for.
std::size_t point_at(const Axis& axis, std::size_t points, double time, double period) {
  const double from = time - kCycleRounding * period;
  std::size_t low = 0;
  std::size_t high = points;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    (axis.at(middle) < from ? low = middle + 1 : high = middle);
  }
  return low;
}

/// 1, Re z, Im z, Re z², … with z = e^{−iω(t − origin)} at points of one block.
Eigen::MatrixXd columns(const Axis& axis, std::size_t first, std::size_t last, double omega,
                        double origin, std::size_t order) {
  Eigen::MatrixXd a(static_cast<Index>(last - first), static_cast<Index>(2 * order + 1));
  a.col(0).setOnes();
  for (Index i = 0; i < a.rows(); ++i) {
    const double t = axis.at(first + static_cast<std::size_t>(i)) - origin;
    const Complex z = std::polar(1.0, -omega * t);
    Complex power = z;
    for (Index n = 0; n < static_cast<Index>(order); ++n, power *= z) {
      a(i, 2 * n + 1) = power.real();
      a(i, 2 * n + 2) = power.imag();
    }
  }
  return a;
}

/// Series of all signals in the points [first, last), by linear least squares.
std::vector<FourierSeries> fit_block(const Axis& axis, const Eigen::MatrixXd& signals,
                                     std::size_t first, std::size_t last, double omega,
                                     std::size_t order) {
  // Phases from the middle of the block, so that those of a late one lose nothing by rounding.
  const double origin = 0.5 * (axis.at(first) + axis.at(last - 1));
  const Eigen::MatrixXd a = columns(axis, first, last, omega, origin, order);
  const auto y = signals.middleRows(static_cast<Index>(first), a.rows());
  const Eigen::LDLT<Eigen::MatrixXd> gram((a.transpose() * a).eval());
  const Eigen::MatrixXd x = gram.solve(a.transpose() * y);
  std::vector<FourierSeries> result;
  for (Index j = 0; j < x.cols(); ++j) {
    FourierSeries series;
    series.omega = omega;
    series.mean = x(0, j);
    for (Index n = 0; n < static_cast<Index>(order); ++n) {
      series.harmonic.emplace_back(x(2 * n + 1, j), x(2 * n + 2, j));
    }
    result.push_back(shifted(series, -origin));
    result.back().trend_centre = 0.0;
  }
  return result;
}

/// The longest time without a point in a span of time that holds the points [first, last).
double longest_hole(const Axis& axis, std::pair<double, double> span, std::size_t first,
                    std::size_t last) {
  if (axis.even()) return 0.0;  // there are enough points, so there is none
  double longest = std::max(axis.at(first) - span.first, span.second - axis.at(last - 1));
  for (std::size_t i = first + 1; i < last; ++i) {
    longest = std::max(longest, axis.at(i) - axis.at(i - 1));
  }
  return longest;
}

/// The signals less their trends: points × signals.
Eigen::MatrixXd without_trend(const Axis& axis, Signals signals, const FourierFit& fit) {
  Eigen::MatrixXd result(static_cast<Index>(fit.points), static_cast<Index>(signals.size()));
  for (std::size_t j = 0; j < signals.size(); ++j) {
    FourierSeries trend = fit.series[j];
    trend.mean = 0.0;
    trend.harmonic.clear();
    for (std::size_t i = 0; i < fit.points; ++i) {
      result(static_cast<Index>(i), static_cast<Index>(j)) =
          signals[j][i] - (trend.trend.empty() ? 0.0 : trend.value(axis.at(i)));
    }
  }
  return result;
}

/// Correlation of neighbouring values about the given mean, unbiased to first order, less its
/// standard error 1/√N: chance alone gives independent values that much.
double lag_one(std::span<const double> deviations) {
  double square = 0.0;
  double product = 0.0;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    square += deviations[i] * deviations[i];
    if (i > 0) product += deviations[i] * deviations[i - 1];
  }
  if (!(square > 0.0)) return 0.0;
  const double biased = product / square;
  const double n = static_cast<double>(deviations.size());
  return std::clamp(biased + 1.0 / n - 1.0 / std::sqrt(n), 0.0, kLargestCorrelation);
}

double inflation(double correlation) { return (1.0 + correlation) / (1.0 - correlation); }

/// Slope and its standard error of the straight line through the values, one per unit of x.
void add_slope(std::span<const double> values, Scatter& result) {
  const double n = static_cast<double>(values.size());
  const double centre = 0.5 * (n - 1.0);
  const double square = n * (n * n - 1.0) / 12.0;
  double product = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    product += (static_cast<double>(i) - centre) * (values[i] - result.mean);
  }
  result.slope = product / square;
  std::vector<double> left(values.size());
  double residual = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    left[i] = values[i] - result.mean - result.slope * (static_cast<double>(i) - centre);
    residual += left[i] * left[i];
  }
  result.slope_std = std::sqrt(residual / (n - 2.0) / square * inflation(lag_one(left)));
}

}  // namespace

CycleSeries cycle_series(const Axis& axis, Signals signals, const FourierFit& fit,
                         const CycleSeriesOptions& options) {
  check(axis, signals, fit, options);
  const std::size_t order = std::min(static_cast<std::size_t>(options.order), fit.order());
  const double period = 2.0 * std::numbers::pi / fit.omega;
  const double per_cycle = static_cast<double>(fit.points) / fit.cycles;
  const double wanted = kPointsPerUnknown * (2.0 * static_cast<double>(order) + 1.0);
  CycleSeries result;
  constexpr double kMostCycles = 1e9;
  result.cycles_per_block =
      static_cast<int>(std::clamp(std::ceil(wanted / per_cycle), 1.0, kMostCycles));
  const double length = result.cycles_per_block * period;
  const double start = axis.at(0);
  const double ratio = (end_of(axis, fit.points) - start) / length + kCycleRounding;
  // Not more than points, and none for an axis that does not rise or is no number.
  const auto blocks =
      ratio > 0.0 ? static_cast<std::size_t>(std::min(ratio, static_cast<double>(fit.points))) : 0;
  const Eigen::MatrixXd values = without_trend(axis, signals, fit);
  for (std::size_t b = 0; b < blocks; ++b) {
    const double begin = start + static_cast<double>(b) * length;
    const std::size_t first = point_at(axis, fit.points, begin, period);
    const std::size_t last = point_at(axis, fit.points, begin + length, period);
    // Uneven times may leave a block too few points, or a hole in it.
    if (last < first + 2 * order + 2) continue;
    if (longest_hole(axis, {begin, begin + length}, first, last) >
        0.5 * period / static_cast<double>(order)) {
      continue;
    }
    result.middle.push_back(begin + 0.5 * length);
    result.block.push_back(fit_block(axis, values, first, last, fit.omega, order));
  }
  return result;
}

double Scatter::slope_significance() const {
  return slope_std > 0.0 ? std::abs(slope) / slope_std : 0.0;
}

Scatter scatter(std::span<const double> values) {
  if (values.empty()) throw InputError("number of values", 0.0, "must be at least 1");
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const double n = static_cast<double>(values.size());
  Scatter result;
  result.count = values.size();
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  std::vector<double> deviations;
  for (const double value : values) deviations.push_back(value - result.mean);
  double square = 0.0;
  for (const double deviation : deviations) square += deviation * deviation;
  result.standard_error = kUnknown;
  result.slope_std = kUnknown;
  result.deviation = values.size() > 1 ? std::sqrt(square / (n - 1.0)) : kUnknown;
  if (values.size() < kLeastValues) return result;
  result.correlation = lag_one(deviations);
  result.standard_error = result.deviation * std::sqrt(inflation(result.correlation) / n);
  add_slope(values, result);
  return result;
}

Scatter scatter(const CycleSeries& cycles,
                const std::function<double(std::span<const FourierSeries>)>& quantity) {
  std::vector<double> values;
  for (const std::vector<FourierSeries>& block : cycles.block) values.push_back(quantity(block));
  return scatter(values);
}

}  // namespace microslip
