// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/signal_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "microslip/base/error.hpp"
#include "microslip/base/median.hpp"
#include "microslip/base/percent.hpp"

namespace microslip {
namespace {

/// Points [first, last) of one value.
struct Run {
  std::size_t first;
  std::size_t last;

  [[nodiscard]] std::size_t size() const { return last - first; }
};

/// All runs of values that differ from their first by no more than a tolerance.
std::vector<Run> runs_of(std::span<const double> signal, double tolerance, std::size_t least) {
  std::vector<Run> runs;
  for (std::size_t first = 0; first < signal.size();) {
    std::size_t last = first + 1;
    while (last < signal.size() && std::abs(signal[last] - signal[first]) <= tolerance) ++last;
    if (last - first >= least) runs.push_back({first, last});
    first = last;
  }
  return runs;
}

/// The smallest change from one point to the next, of those that change: the step of a converter,
/// or less.
double smallest_step(std::span<const double> signal, double tolerance) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < signal.size(); ++i) {
    const double step = std::abs(signal[i] - signal[i - 1]);
    if (step > tolerance) smallest = std::min(smallest, step);
  }
  return smallest;
}

/// The larger of the changes into and out of a run; 0 where the record has neither.
double step_beside(std::span<const double> signal, const Run& run) {
  const double before = run.first > 0 ? std::abs(signal[run.first] - signal[run.first - 1]) : 0.0;
  const double after =
      run.last < signal.size() ? std::abs(signal[run.last] - signal[run.last - 1]) : 0.0;
  return std::max(before, after);
}

struct Extremes {
  double smallest;
  double largest;
  double tolerance;

  [[nodiscard]] bool holds(double value) const {
    return value >= largest - tolerance || value <= smallest + tolerance;
  }
};

Extremes extremes_of(std::span<const double> signal, double level_tolerance) {
  if (signal.empty()) return {0.0, 0.0, 0.0};
  const auto [low, high] = std::ranges::minmax_element(signal);
  return {*low, *high, level_tolerance * (*high - *low)};
}

/// Removes the pair of neighbours, around the period, that differs least, as long as that is no
/// more than the threshold. What is left still goes up and down in turn.
void remove_small_ranges(std::vector<TurningPoint>& points, double threshold) {
  while (!points.empty()) {
    std::size_t least = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double range = std::abs(points[(i + 1) % points.size()].value - points[i].value);
      if (range < smallest) {
        smallest = range;
        least = i;
      }
    }
    if (smallest > threshold) return;
    const std::size_t next = (least + 1) % points.size();
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(std::max(least, next)));
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(std::min(least, next)));
  }
}

void check_at_least(std::string_view what, double value, double least) {
  if (value >= least && std::isfinite(value)) return;
  throw InputError(what, value, fmt::format("must be {:g} or more", least));
}

void add_warnings(std::string_view name, SignalQuality& quality) {
  if (quality.clipping.clipped) {
    quality.warnings.push_back(
        {"clipped",
         fmt::format("{}: {} of the points lie in {} flat tops at the extremes: "
                     "the signal is clipped; widen the range of the channel",
                     name, percent_text(quality.clipping.share), quality.clipping.runs)});
  }
  const Dropouts& lost = quality.dropouts;
  if (lost.found()) {
    quality.warnings.push_back(
        {"dropout", fmt::format("{}: {} runs of one value, the longest of {} points, and {} gaps "
                                "of the time axis, the longest of {:.3g} s",
                                name, lost.runs, lost.longest_run, lost.gaps, lost.longest_gap)});
  }
  if (quality.drifts) {
    quality.warnings.push_back(
        {"amplitude_drift",
         fmt::format("{}: the amplitude changes by {} over the record, {:.1f} standard "
                     "errors; wait longer for the steady state",
                     name, percent_text(quality.amplitude_change),
                     quality.amplitude.slope_significance())});
  }
}

void add_drift(const CycleSeries& cycles, std::size_t index, const SignalQualityOptions& options,
               SignalQuality& quality) {
  if (cycles.block.empty()) return;
  for (const std::vector<FourierSeries>& block : cycles.block) {
    if (index < block.size()) continue;
    throw InputError("signals of a block", static_cast<double>(block.size()),
                     fmt::format("must be above {}, the index of the signal", index));
  }
  quality.amplitude = scatter(cycles, [index](std::span<const FourierSeries> signals) {
    return std::abs(signals[index].c(1));
  });
  const Scatter& amplitude = quality.amplitude;
  if (!(amplitude.mean > 0.0) || !std::isfinite(amplitude.slope_std)) return;
  quality.amplitude_change =
      amplitude.slope * static_cast<double>(amplitude.count) / amplitude.mean;
  quality.drifts = std::abs(quality.amplitude_change) > options.drift_share &&
                   amplitude.slope_significance() > options.drift_significance;
}

}  // namespace

Reversals reversals(const FourierSeries& series, std::span<const double> harmonic_std,
                    const ReversalOptions& options) {
  check_at_least("noise_factor", options.noise_factor, 0.0);
  if (!harmonic_std.empty() && harmonic_std.size() != series.order()) {
    throw InputError("number of harmonic_std", static_cast<double>(harmonic_std.size()),
                     fmt::format("must be {}, one per harmonic, or 0", series.order()));
  }
  double variance = 0.0;
  for (const double error : harmonic_std) variance += error * error;
  Reversals result;
  result.threshold = options.noise_factor * std::sqrt(2.0 * variance);
  result.points = turning_points(series);
  remove_small_ranges(result.points, result.threshold);
  return result;
}

double distortion(const FourierSeries& series) {
  return std::numbers::sqrt2 * rms(series, 2) / std::abs(series.c(1));
}

Clipping find_clipping(std::span<const double> signal, const ClippingOptions& options) {
  check_at_least("least_run", static_cast<double>(options.least_run), 2.0);
  check_at_least("level_tolerance", options.level_tolerance, 0.0);
  const Extremes extremes = extremes_of(signal, options.level_tolerance);
  const double least_step = options.least_step * smallest_step(signal, extremes.tolerance);
  Clipping result;
  for (const Run& run : runs_of(signal, extremes.tolerance, options.least_run)) {
    if (!extremes.holds(signal[run.first]) || step_beside(signal, run) <= least_step) continue;
    ++result.runs;
    result.points += run.size();
  }
  if (result.points == 0) return result;
  result.share = static_cast<double>(result.points) / static_cast<double>(signal.size());
  result.clipped = result.share > options.least_share;
  return result;
}

Dropouts find_dropouts(const Axis& axis, std::span<const double> signal,
                       const DropoutOptions& options) {
  check_at_least("least_run", static_cast<double>(options.least_run), 3.0);
  check_at_least("gap_factor", options.gap_factor, 1.0);
  const Extremes extremes = extremes_of(signal, 0.0);
  const double least_step = options.least_step * smallest_step(signal, 0.0);
  Dropouts result;
  for (const Run& run : runs_of(signal, 0.0, options.least_run)) {
    if (extremes.holds(signal[run.first]) || step_beside(signal, run) <= least_step) continue;
    ++result.runs;
    result.points += run.size();
    result.longest_run = std::max(result.longest_run, run.size());
  }
  if (axis.values.size() < 2) return result;
  std::vector<double> steps;
  for (std::size_t i = 1; i < axis.values.size(); ++i) {
    if (!(axis.values[i] > axis.values[i - 1])) {
      throw InputError(fmt::format("time {}", i + 1), axis.values[i],
                       "must be later than the previous time");
    }
    steps.push_back(axis.values[i] - axis.values[i - 1]);
  }
  const double usual = median(steps);
  for (const double step : steps) {
    if (step <= options.gap_factor * usual) continue;
    ++result.gaps;
    result.longest_gap = std::max(result.longest_gap, step);
  }
  return result;
}

SignalQuality signal_quality(const Axis& axis, std::span<const std::span<const double>> signals,
                             const FourierFit& fit, const CycleSeries& cycles, std::size_t index,
                             std::string_view name, const SignalQualityOptions& options) {
  if (index >= signals.size() || signals.size() != fit.series.size()) {
    throw InputError("index of the signal", static_cast<double>(index),
                     fmt::format("must be below {}, the number of signals", fit.series.size()));
  }
  if (fit.harmonic_std.size() != fit.series.size()) {
    throw InputError("number of harmonic_std of the fit",
                     static_cast<double>(fit.harmonic_std.size()),
                     fmt::format("must be {}, one per signal", fit.series.size()));
  }
  SignalQuality result;
  const FourierSeries& series = fit.series[index];
  result.reversals = reversals(series, fit.harmonic_std[index], options.reversals);
  result.distortion = distortion(series);
  result.clipping = find_clipping(signals[index], options.clipping);
  result.dropouts = find_dropouts(axis, signals[index], options.dropouts);
  add_drift(cycles, index, options, result);
  add_warnings(name, result);
  return result;
}

}  // namespace microslip
