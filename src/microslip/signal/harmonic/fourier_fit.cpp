// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/fourier_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/signal/harmonic/coefficient_errors.hpp"
#include "microslip/signal/harmonic/fundamental.hpp"
#include "microslip/signal/harmonic/harmonic_regression.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Signals = std::span<const std::span<const double>>;

constexpr int kLargestOrder = 100;
constexpr int kLargestTrendDegree = 4;
constexpr double kLargestTolerance = 0.3;
/// A signal whose variance about its trend is below this share of its largest square is rounding.
constexpr double kConstant = 1e-26;

void check_options(const FourierFitOptions& options) {
  const auto in_range = [](std::string_view what, double value, double lowest, double highest) {
    if (value >= lowest && value <= highest) return;
    throw InputError(what, value, fmt::format("must be from {:g} to {:g}", lowest, highest));
  };
  in_range("order", options.order, 1, kLargestOrder);
  in_range("trend_degree", options.trend_degree, 0, kLargestTrendDegree);
  in_range("max_iterations", options.max_iterations, 1, 1e6);
  if (!(options.least_explained >= 0.0 && options.least_explained < 1.0)) {
    throw InputError("least_explained", options.least_explained, "must be in [0, 1)");
  }
  if (!(options.guess_tolerance > 0.0 && options.guess_tolerance <= kLargestTolerance)) {
    throw InputError("guess_tolerance", options.guess_tolerance, "must be in (0, 0.3]");
  }
  if (!options.frequency_guess) {
    if (options.fit_frequency) return;
    throw InputError("frequency_guess", "none", "must be given where fit_frequency is false");
  }
  if (!(*options.frequency_guess > 0.0 && std::isfinite(*options.frequency_guess))) {
    throw InputError("frequency_guess", *options.frequency_guess, "must be above 0 Hz and finite");
  }
}

void check_axis(const Axis& axis, std::size_t points) {
  if (axis.dimension != kTime) {
    throw InputError("axis of the signals", dimension_name(axis.dimension), "must be time");
  }
  if (axis.even()) {
    if (axis.step > 0.0 && std::isfinite(axis.step) && std::isfinite(axis.start)) return;
    throw InputError("step of the axis", axis.step, "must be above 0 s and finite");
  }
  if (axis.values.size() != points) {
    throw InputError("number of times", static_cast<double>(axis.values.size()),
                     fmt::format("must be {}, that of the values", points));
  }
  for (std::size_t i = 0; i < points; ++i) {
    if (std::isfinite(axis.values[i]) && (i == 0 || axis.values[i] > axis.values[i - 1])) continue;
    throw InputError(fmt::format("time {}", i + 1), axis.values[i],
                     "must be finite and above the previous one");
  }
}

void check_signals(const Axis& axis, Signals signals) {
  constexpr std::size_t kLeastPoints = 8;
  if (signals.empty()) throw InputError("signals", "none", "must be at least one");
  const std::size_t points = signals.front().size();
  if (points < kLeastPoints) {
    throw InputError("number of points", static_cast<double>(points), "must be at least 8");
  }
  check_axis(axis, points);
  for (std::size_t j = 0; j < signals.size(); ++j) {
    const std::string name = fmt::format("signal {}", j + 1);
    if (signals[j].size() != points) {
      throw InputError(name + " length", static_cast<double>(signals[j].size()),
                       fmt::format("must be {}, that of the others", points));
    }
    const auto bad =
        std::ranges::find_if_not(signals[j], [](double v) { return std::isfinite(v); });
    if (bad == signals[j].end()) continue;
    throw InputError(fmt::format("{}, point {}", name, bad - signals[j].begin() + 1), *bad,
                     "must be finite");
  }
}

/// The signals less their trends, over their rms; those that are constant left out.
struct Prepared {
  Eigen::MatrixXd scaled;      ///< points × moving signals
  std::vector<Index> column;   ///< of each signal in scaled; −1 where it is constant
  Eigen::MatrixXd polynomial;  ///< subtracted Legendre coefficients: × all signals, [x]
  Eigen::VectorXd scale;       ///< rms per signal, [x]; 0 where it is constant
};

Prepared prepare(const RecordTimes& times, Signals signals, Index degree) {
  const Index points = times.points();
  const auto count = static_cast<Index>(signals.size());
  Eigen::MatrixXd values(points, count);
  for (Index j = 0; j < count; ++j) {
    values.col(j) =
        Eigen::Map<const Eigen::VectorXd>(signals[static_cast<std::size_t>(j)].data(), points);
  }
  const Eigen::ArrayXd largest = values.cwiseAbs2().colwise().maxCoeff().transpose();
  const Eigen::MatrixXd p = legendre_at(
      Eigen::VectorXd::NullaryExpr(points, [&times](Index i) { return times.s(i); }), degree);
  Prepared result;
  result.polynomial = (p.transpose() * p).eval().ldlt().solve(p.transpose() * values);
  values.noalias() -= p * result.polynomial;
  result.scale = values.colwise().norm().transpose() / std::sqrt(static_cast<double>(points));
  Index moving = 0;
  for (Index j = 0; j < count; ++j) {
    if (result.scale(j) * result.scale(j) <= kConstant * largest(j)) result.scale(j) = 0.0;
    result.column.push_back(result.scale(j) > 0.0 ? moving++ : Index{-1});
    if (result.column.back() >= 0) values.col(moving - 1) = values.col(j) / result.scale(j);
  }
  result.scaled = values.leftCols(moving);
  return result;
}

/// The fit of nothing: mean and trend of each signal and no harmonics.
FourierFit empty_fit(const RecordTimes& times, const Prepared& prepared) {
  FourierFit fit;
  fit.middle = times.middle();
  fit.points = static_cast<std::size_t>(times.points());
  fit.summary.method = "Fourier series with fitted frequency";
  for (Index j = 0; j < prepared.scale.size(); ++j) {
    const Eigen::VectorXd trend = prepared.polynomial.col(j);
    FourierSeries series;
    series.mean = trend(0);
    series.trend.assign(trend.begin() + 1, trend.end());
    series.trend_centre = times.middle();
    series.trend_half_width = times.half_width();
    fit.series.push_back(std::move(series));
    fit.residual_rms.push_back(prepared.scale(j));
    fit.residual_peak.push_back(0.0);
    fit.peak_point.push_back(0);
    fit.harmonic_std.emplace_back();
    fit.explained.push_back(0.0);
    if (prepared.scale(j) > 0.0) continue;
    fit.warnings.push_back(
        {"signal_constant", fmt::format("signal {} is constant or a straight line: its harmonics "
                                        "are 0; is the channel connected?",
                                        j + 1)});
  }
  return fit;
}

/// Coefficients of one signal, in its unit and with the zero of time that of the axis.
void fill_series(const HarmonicFit& found, const Prepared& prepared, Index signal, double omega,
                 FourierFit& fit) {
  FourierSeries& series = fit.series[static_cast<std::size_t>(signal)];
  series.omega = omega;
  series.harmonic.assign(static_cast<std::size_t>(found.order), 0.0);
  const Index column = prepared.column[static_cast<std::size_t>(signal)];
  if (column < 0) return;
  const double scale = prepared.scale(signal);
  series.mean += scale * found.coefficients(0, column);
  for (std::size_t k = 0; k < series.trend.size(); ++k) {
    series.trend[k] += scale * found.coefficients(static_cast<Index>(k) + 1, column);
  }
  const Eigen::MatrixXcd c = found.harmonics();
  for (Index n = 1; n <= found.order; ++n) {
    const double turn = -static_cast<double>(n) * omega * fit.middle;
    series.harmonic[static_cast<std::size_t>(n - 1)] =
        scale * c(n - 1, column) * std::polar(1.0, turn);
  }
}

/// Standard errors and what is left of one signal.
void fill_errors(const CoefficientErrors& errors, const Eigen::MatrixXd& residuals,
                 const Prepared& prepared, Index signal, FourierFit& fit) {
  const auto j = static_cast<std::size_t>(signal);
  fit.harmonic_std[j].assign(fit.order(), 0.0);
  const Index column = prepared.column[j];
  if (column < 0) return;
  const double scale = prepared.scale(signal);
  const double points = static_cast<double>(residuals.rows());
  const double left = residuals.col(column).squaredNorm() / points;
  fit.residual_rms[j] = scale * std::sqrt(left);
  Index peak = 0;
  fit.residual_peak[j] = scale * residuals.col(column).cwiseAbs().maxCoeff(&peak);
  fit.peak_point[j] = static_cast<std::size_t>(peak);
  const double constants = static_cast<double>(fit.series[j].trend.size()) + 1.0;
  const double unknowns = static_cast<double>(errors.coefficients.rows());
  fit.explained[j] = std::max(0.0, 1.0 - left * (points - constants) / (points - unknowns));
  const Index first = errors.coefficients.rows() - 2 * static_cast<Index>(fit.order());
  for (std::size_t n = 0; n < fit.order(); ++n) {
    const Index row = first + 2 * static_cast<Index>(n);
    fit.harmonic_std[j][n] =
        scale * errors.coefficients.col(column).segment(row, 2).norm() * std::numbers::sqrt2 / 2.0;
  }
}

void fill(const HarmonicRegression& regression, const HarmonicFit& found, const Prepared& prepared,
          const FourierFitOptions& options, FourierFit& fit) {
  const RecordTimes& times = regression.times();
  fit.omega = found.big_omega / times.half_width();
  fit.cycles = fit.frequency() * times.length();
  const Eigen::MatrixXd residuals = regression.residuals(found);
  const CoefficientErrors errors =
      coefficient_errors(regression, found, residuals, options.residuals, !options.fit_frequency);
  fit.omega_std = errors.big_omega / times.half_width();
  for (Index j = 0; j < prepared.scale.size(); ++j) {
    fill_series(found, prepared, j, fit.omega, fit);
    fill_errors(errors, residuals, prepared, j, fit);
  }
}

FourierFit fit_prepared(const RecordTimes& times, const Prepared& prepared,
                        const FourierFitOptions& options) {
  FourierFit fit = empty_fit(times, prepared);
  fit.summary.stop = Stop::kNoProgress;
  if (prepared.scaled.cols() == 0) {
    fit.summary.reason = "no periodic content: all signals are constant";
    return fit;
  }
  const HarmonicRegression regression(times, prepared.scaled, options.trend_degree);
  Fundamental found = find_fundamental(regression, prepared.scaled, options);
  fit.summary.iterations = found.iterations;
  fit.summary.residual = found.step;
  fit.summary.reason = found.failure;
  std::ranges::move(found.warnings, std::back_inserter(fit.warnings));
  if (found.fit.determined) fill(regression, found.fit, prepared, options, fit);
  if (!found.failure.empty()) return fit;
  fit.summary.stop = options.fit_frequency ? Stop::kConverged : Stop::kClosedForm;
  fit.summary.reason = options.fit_frequency
                           ? "the next step of the frequency is far below its standard error"
                           : "the frequency was given";
  return fit;
}

}  // namespace

double FourierFit::frequency() const { return omega / (2.0 * std::numbers::pi); }

FourierFit fit_fourier(const Axis& axis, Signals signals, const FourierFitOptions& options) {
  const Stopwatch watch;
  check_options(options);
  check_signals(axis, signals);
  const RecordTimes times(axis, signals.front().size());
  const Prepared prepared = prepare(times, signals, options.trend_degree);
  FourierFit fit = fit_prepared(times, prepared, options);
  fit.summary.wall_seconds = watch.seconds();
  return fit;
}

}  // namespace microslip
