// SPDX-License-Identifier: MIT
#include "microslip/signal/recording/resampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace microslip {
namespace {

constexpr std::size_t kPoints = 6;        // of a polynomial
constexpr double kLongestInterval = 3.0;  // mean intervals; a longer one is a gap
constexpr double kLowestRate = 0.99;      // mean rates: times of a clock may be off
constexpr double kHighestRate = 100.0;    // mean rates

std::vector<double> times_of(const Recording& recording) {
  std::vector<double> times(recording.size());
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = recording.axis.at(i);
  return times;
}

double mean_interval(std::span<const double> times) {
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

void check_channels(const Recording& recording) {
  if (recording.axis.dimension != kTime) {
    throw InputError(recording.source, InputState{"not over time"},
                     "must be over time to be resampled");
  }
  for (const Channel& channel : recording.channels) {
    if (channel.imaginary.empty()) continue;
    throw InputError(fmt::format("{}: channel '{}'", recording.source, channel.name),
                     InputState{"complex"}, "must be real to be resampled",
                     "Choose the others with `channel`.");
  }
}

void check_gaps(const Recording& recording, std::span<const double> times) {
  const double mean = mean_interval(times);
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] - times[i - 1] <= kLongestInterval * mean) continue;
    throw InputError(
        fmt::format("{}: time", recording.source),
        InputState{fmt::format("without a sample from {:.6g} to {:.6g} s", times[i - 1], times[i])},
        fmt::format("must have one within {:g} mean intervals of {:.4g} s", kLongestInterval, mean),
        "Take the parts before and after apart.");
  }
}

void check_rate(const Recording& recording, double rate, double mean) {
  if (rate >= kLowestRate * mean && rate <= kHighestRate * mean) return;
  throw InputError(
      "`resample`", fmt::format("{:g} Hz", rate),
      fmt::format("must be {:.6g} Hz, the mean rate of {}, or more, up to {:g} times it", mean,
                  recording.source, kHighestRate),
      rate < mean ? "A lower one would need a filter against aliasing: apply it first." : "");
}

/// The first of the points of the polynomial for a time, and its values there.
struct Weights {
  std::size_t first = 0;
  std::vector<double> of_points;
};

Weights weights_at(double time, std::span<const double> times) {
  const std::size_t count = std::min(kPoints, times.size());
  const auto above =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  const std::size_t half = count / 2;
  Weights weights{std::min(above > half ? above - half : 0, times.size() - count), {}};
  const std::span<const double> near = times.subspan(weights.first, count);
  for (const double own : near) {
    double product = 1.0;
    for (const double other : near) {
      if (other != own) product *= (time - other) / (own - other);
    }
    weights.of_points.push_back(product);
  }
  return weights;
}

}  // namespace

Recording resampled(const Recording& recording, double rate) {
  check_channels(recording);
  const std::vector<double> times = times_of(recording);
  check_gaps(recording, times);
  check_rate(recording, rate, 1.0 / mean_interval(times));
  const double step = 1.0 / rate;
  constexpr double kRounding = 1e-9;  // of a step: the last point is not lost by it
  const auto count =
      1 + static_cast<std::size_t>((times.back() - times.front()) * rate + kRounding);

  Recording result = recording;
  result.axis = {.dimension = kTime, .start = times.front(), .step = step, .values = {}};
  for (Channel& channel : result.channels) channel.values.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double time = std::min(result.axis.at(i), times.back());
    const Weights weights = weights_at(time, times);
    for (std::size_t c = 0; c < recording.channels.size(); ++c) {
      const std::vector<double>& values = recording.channels[c].values;
      for (std::size_t k = 0; k < weights.of_points.size(); ++k) {
        result.channels[c].values[i] += weights.of_points[k] * values[weights.first + k];
      }
    }
  }
  return result;
}

InputError uneven_times(const Recording& recording) {
  const std::vector<double> times = times_of(recording);
  double shortest = times.back() - times.front();
  double longest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    shortest = std::min(shortest, times[i] - times[i - 1]);
    longest = std::max(longest, times[i] - times[i - 1]);
  }
  return {fmt::format("{}: time", recording.source),
          InputState{fmt::format("uneven: intervals of {:.4g} to {:.4g} s", shortest, longest)},
          "must be evenly spaced",
          fmt::format("Resample it first: `microslip convert IN OUT --resample {:.6g}Hz`.",
                      1.0 / mean_interval(times))};
}

}  // namespace microslip
