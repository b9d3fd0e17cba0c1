// SPDX-License-Identifier: MIT
#include "signal/synthetic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace microslip::test {

std::vector<std::span<const double>> spans(const Signals& signals) {
  return {signals.begin(), signals.end()};
}

Axis even_axis(double rate, double start) {
  Axis axis;
  axis.start = start;
  axis.step = 1.0 / rate;
  return axis;
}

Axis jittered_axis(const Axis& even, std::size_t points, double jitter, std::uint64_t seed) {
  RandomStream random(seed, 77);
  Axis axis;
  for (std::size_t i = 0; i < points; ++i) {
    axis.values.push_back(even.at(i) + jitter * even.step * (2.0 * random.uniform() - 1.0));
  }
  return axis;
}

FourierSeries series_of(double frequency, std::size_t order, double amplitude, double share,
                        double phase) {
  FourierSeries series;
  series.omega = kTwoPi * frequency;
  for (std::size_t n = 1; n <= order; ++n) {
    const double number = static_cast<double>(n);
    series.harmonic.push_back(
        std::polar(amplitude * std::pow(share, number - 1.0), phase + number * number));
  }
  return series;
}

std::vector<double> sampled(const FourierSeries& series, const Axis& axis, std::size_t points,
                            double noise, std::uint64_t seed, std::uint64_t stream) {
  std::vector<double> result = values(series, axis, points);
  RandomStream random(seed, stream);
  if (noise > 0.0) {
    for (double& value : result) value += noise * random.normal();
  }
  return result;
}

double coefficient_error(const FourierSeries& found, const FourierSeries& truth) {
  double error = 0.0;
  double largest = 0.0;
  for (std::size_t n = 1; n <= std::max(found.order(), truth.order()); ++n) {
    error = std::max(error, std::abs(found.c(n) - truth.c(n)));
    largest = std::max(largest, std::abs(truth.c(n)));
  }
  return error / largest;
}

}  // namespace microslip::test
