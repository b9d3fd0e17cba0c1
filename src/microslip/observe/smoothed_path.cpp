// SPDX-License-Identifier: MIT
#include "microslip/observe/smoothed_path.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "microslip/base/median.hpp"
#include "microslip/observe/path_noise.hpp"

namespace microslip {
namespace {

/// P of a line is the mean over its neighbours up to this ratio of frequencies, these at least.
constexpr double kNeighbourRatio = 1.1;
constexpr std::size_t kFewestLines = 6;
/// Median over mean of the exponential distribution that the power of noise has.
constexpr double kMedianOfPower = std::numbers::ln2;
constexpr std::size_t kLeastPad = 32;
/// Turns of noise are smaller than so many of its standard deviations.
constexpr double kTurnDeviations = 6.0;

/// The next length of which a Fourier transform is quick: factors 2, 3 and 5 alone, even.
std::size_t quick_length(std::size_t n) {
  for (n += n % 2;; n += 2) {
    std::size_t left = n;
    for (const std::size_t factor : {2U, 3U, 5U}) {
      while (left % factor == 0) left /= factor;
    }
    if (left == 1) return n;
  }
}

/// The path less the line through its ends, and beyond them its odd reflection, which fades out:
/// periodic without a jump. The ends are those without noise: a reflection about a sample keeps its
/// noise whole, and a virgin joint is without force at the first.
struct Periodic {
  std::vector<double> values;
  std::size_t first = 0;  ///< of the path in it
  double start;           ///< of the line
  double slope;           ///< per sample

  Periodic(std::span<const double> path, double first_end, double last_end)
      : start(first_end), slope((last_end - first_end) / static_cast<double>(path.size() - 1)) {
    const std::size_t n = path.size();
    const std::size_t pad = std::min(n - 1, std::max(kLeastPad, n / 16));
    const std::size_t length = quick_length(n + 2 * pad);
    first = (length - n) / 2;
    values.assign(length, 0.0);
    for (std::size_t i = 0; i < n; ++i) values[first + i] = path[i] - line(i);
    for (std::size_t i = 1; i <= pad; ++i) {
      const double phase = static_cast<double>(i) / static_cast<double>(pad);
      const double taper = 0.5 + 0.5 * std::cos(std::numbers::pi * phase);
      values[first - i] = -taper * values[first + i];
      values[first + n - 1 + i] = -taper * values[first + n - 1 - i];
    }
  }

  [[nodiscard]] double line(std::size_t i) const { return start + slope * static_cast<double>(i); }
};

/// Mean power about each line.
std::vector<double> smoothed_power(const std::vector<std::complex<double>>& spectrum) {
  const std::size_t n = spectrum.size();
  std::vector<double> sum(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) sum[i + 1] = sum[i] + std::norm(spectrum[i]);
  std::vector<double> power(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto reach =
        static_cast<std::size_t>(static_cast<double>(i) * (1.0 - 1.0 / kNeighbourRatio));
    const std::size_t beside = std::max(kFewestLines, reach);
    const std::size_t from = i > beside ? i - beside : 0;
    const std::size_t to = std::min(n, i + beside + 1);
    power[i] = (sum[to] - sum[from]) / static_cast<double>(to - from);
  }
  return power;
}

double noise_power(const std::vector<std::complex<double>>& spectrum) {
  std::vector<double> upper;
  for (std::size_t i = 3 * spectrum.size() / 4; i < spectrum.size(); ++i) {
    upper.push_back(std::norm(spectrum[i]));
  }
  return median(std::move(upper)) / kMedianOfPower;
}

/// Adds the parts of corners to samples of a path, times a factor.
void add_corners(const std::vector<PathCorner>& corners, double factor, std::vector<double>& path) {
  const auto size = static_cast<double>(path.size());
  const std::vector<double> reach = reach_of_corners(corners, size);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double at = corners[k].at;
    const auto from = static_cast<std::size_t>(std::max(0.0, at - reach[k]));
    const auto to = static_cast<std::size_t>(std::min(size, at + reach[k] + 1.0));
    for (std::size_t i = from; i < to; ++i) {
      path[i] += factor * corners[k].value(static_cast<double>(i) - at, reach[k]);
    }
  }
}

}  // namespace

double SmoothedPath::smallest_turn() const {
  const auto [low, high] = std::ranges::minmax(displacement);
  const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * (high - low);
  return std::max(kTurnDeviations * left, rounding);
}

SmoothedPath smooth_path(std::span<const double> displacement) {
  SmoothedPath result;
  result.corners = path_corners(displacement);
  result.displacement.assign(displacement.begin(), displacement.end());
  add_corners(result.corners, -1.0, result.displacement);
  const std::vector<double> reversed(displacement.rbegin(), displacement.rend());
  const Periodic periodic(
      result.displacement,
      result.displacement.front() + first_without_noise(displacement) - displacement.front(),
      result.displacement.back() + first_without_noise(reversed) - displacement.back());
  const std::size_t n = periodic.values.size();
  Eigen::FFT<double> fft(Eigen::default_fft_impl<double>(), Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, periodic.values);

  const double noise = noise_power(spectrum);
  const std::vector<double> power = smoothed_power(spectrum);
  double kept = 0.0;
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double gain = power[i] > noise ? 1.0 - noise / power[i] : 0.0;
    spectrum[i] *= gain;
    kept += gain * gain;
  }
  std::vector<double> values(n);
  fft.inv(values, spectrum, static_cast<Eigen::Index>(n));

  for (std::size_t i = 0; i < displacement.size(); ++i) {
    result.displacement[i] = values[periodic.first + i] + periodic.line(i);
  }
  add_corners(result.corners, 1.0, result.displacement);
  result.noise = std::sqrt(noise / static_cast<double>(n));
  result.left = result.noise * std::sqrt(kept / static_cast<double>(spectrum.size()));
  return result;
}

}  // namespace microslip
