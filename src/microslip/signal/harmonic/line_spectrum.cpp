// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/line_spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <unsupported/Eigen/FFT>

#include "microslip/base/median.hpp"

namespace microslip {
namespace {

using Eigen::Index;

/// Points of the FFT: a power of two, and for short records zeros that make the lines dense.
Index transform_points(Index points) {
  constexpr Index kDense = 32768;
  const Index least = std::max(points, std::min(4 * points, kDense));
  return static_cast<Index>(std::bit_ceil(static_cast<std::size_t>(least)));
}

/// The signal at even steps over the same time.
Eigen::VectorXd at_even_steps(const RecordTimes& times, const Eigen::VectorXd& signal) {
  if (times.even()) return signal;
  Eigen::VectorXd even(signal.size());
  Index left = 0;
  for (Index i = 0; i < even.size(); ++i) {
    const double s = 2.0 * static_cast<double>(i) / static_cast<double>(even.size() - 1) - 1.0;
    while (left + 2 < even.size() && times.s(left + 1) < s) ++left;
    const double share = (s - times.s(left)) / (times.s(left + 1) - times.s(left));
    even(i) = signal(left) + std::clamp(share, 0.0, 1.0) * (signal(left + 1) - signal(left));
  }
  return even;
}

/// Means of `count` neighbours each; what is left at the end is not used.
Eigen::VectorXd means_of(const Eigen::VectorXd& signal, Index count) {
  if (count == 1) return signal;
  const Index means = signal.size() / count;
  return signal.head(means * count).reshaped(count, means).colwise().mean().transpose();
}

Eigen::VectorXd hann_window(Index points) {
  return Eigen::VectorXd::NullaryExpr(points, [points](Index i) {
    const double phase = (static_cast<double>(i) + 0.5) / static_cast<double>(points);
    return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * phase);
  });
}

}  // namespace

LineSpectrum::LineSpectrum(const RecordTimes& times, const Eigen::MatrixXd& signals,
                           double highest) {
  // At an eighth of the rate of the means a line has lost 5 % of its power.
  const double sparse = static_cast<double>(signals.rows()) / (8.0 * highest);
  const Index neighbours = std::max<Index>(1, static_cast<Index>(sparse));
  const Index points = signals.rows() / neighbours;
  const Index transform = transform_points(points);
  bins_per_cycle_ =
      static_cast<double>(transform * neighbours) / static_cast<double>(signals.rows());
  const Eigen::VectorXd window = hann_window(points);
  const double scale = 2.0 / (window.sum() * window.sum());
  power_.resize(transform / 2 + 1, signals.cols());
  noise_.resize(signals.cols());
  Eigen::FFT<double> fft(Eigen::default_fft_impl<double>(), Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> input(static_cast<std::size_t>(transform), 0.0);
  std::vector<std::complex<double>> output;
  for (Index j = 0; j < signals.cols(); ++j) {
    Eigen::Map<Eigen::VectorXd>(input.data(), points) =
        means_of(at_even_steps(times, signals.col(j)), neighbours).cwiseProduct(window);
    fft.fwd(output, input);
    for (Index k = 0; k < power_.rows(); ++k) {
      power_(k, j) = scale * std::norm(output[static_cast<std::size_t>(k)]);
    }
    const auto power = power_.col(j);
    noise_(j) =
        median({power.begin(), power.end()}) / std::numbers::ln2;  // of an exponential distribution
  }
  total_ = power_.rowwise().sum();
}

double LineSpectrum::power(double cycles, Index signal) const {
  const double place = cycles * bins_per_cycle_;
  const Index below = static_cast<Index>(place);
  if (below + 1 >= power_.rows()) return 0.0;
  return std::lerp(power_(below, signal), power_(below + 1, signal),
                   place - static_cast<double>(below));
}

double LineSpectrum::leakage(double distance) {
  const double d = std::abs(distance);
  if (d < 2.0) return 1.0;
  const double amplitude = 1.0 / (std::numbers::pi * d * (d * d - 1.0));
  return amplitude * amplitude;
}

double LineSpectrum::total(double cycles) const {
  const double place = cycles * bins_per_cycle_;
  const Index below = static_cast<Index>(place);
  if (below + 1 >= total_.size()) return 0.0;
  return std::lerp(total_(below), total_(below + 1), place - static_cast<double>(below));
}

std::optional<double> LineSpectrum::strongest(double from, double to) const {
  const Index first = std::max<Index>(1, static_cast<Index>(std::ceil(from * bins_per_cycle_)));
  const Index last =
      std::min<Index>(total_.size() - 2, static_cast<Index>(std::floor(to * bins_per_cycle_)));
  if (first > last) return std::nullopt;
  Index peak = 0;
  const double largest = total_.segment(first, last - first + 1).maxCoeff(&peak);
  peak += first;
  if (!(largest > 0.0)) return std::nullopt;
  // The parabola through the logarithms: the main lobe of the window is nearly one.
  const double tiny = largest * 1e-12;
  const double left = std::log(total_(peak - 1) + tiny);
  const double here = std::log(total_(peak) + tiny);
  const double right = std::log(total_(peak + 1) + tiny);
  const double bend = left - 2.0 * here + right;
  const double offset = bend < 0.0 ? std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) : 0.0;
  return (static_cast<double>(peak) + offset) / bins_per_cycle_;
}

double LineSpectrum::strongest_comb(double from, double to, Index order) const {
  const double step = 0.25 / static_cast<double>(order);  // a quarter of a line at the highest
  const Index steps = std::max<Index>(2, static_cast<Index>(std::ceil((to - from) / step)));
  double best = from;
  double largest = -1.0;
  for (Index i = 0; i <= steps; ++i) {
    const double cycles = std::lerp(from, to, static_cast<double>(i) / static_cast<double>(steps));
    double sum = 0.0;
    for (Index n = 1; n <= order; ++n) sum += total(static_cast<double>(n) * cycles);
    if (sum > largest) {
      largest = sum;
      best = cycles;
    }
  }
  return best;
}

Index LineSpectrum::strongest_multiple(double cycles, Index order) const {
  Index best = 1;
  for (Index n = 2; n <= order; ++n) {
    if (total(static_cast<double>(n) * cycles) > total(static_cast<double>(best) * cycles)) {
      best = n;
    }
  }
  return best;
}

}  // namespace microslip
