// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/mode_peak.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

#include "microslip/base/median.hpp"
#include "microslip/signal/decay/decay_leakage.hpp"
#include "microslip/signal/decay/tapered_transform.hpp"

namespace microslip {
namespace {

constexpr double kLeastPeriods = 24.0;
constexpr double kNear = 0.5;  // lines: farther off a stronger neighbour passes for the mode

/// Magnitudes of the lines 0 to half the sampling rate; zeros behind the values make them so many.
std::vector<double> magnitudes(std::vector<double> values, std::size_t points) {
  values.resize(points, 0.0);
  std::vector<std::complex<double>> lines;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  fft.fwd(lines, values);
  std::vector<double> magnitude(lines.size());
  std::ranges::transform(lines, magnitude.begin(),
                         [](const std::complex<double>& line) { return std::abs(line); });
  return magnitude;
}

std::vector<double> without_mean(std::span<const double> signal) {
  std::vector<double> rest(signal.begin(), signal.end());
  const double mean =
      std::accumulate(rest.begin(), rest.end(), 0.0) / static_cast<double>(rest.size());
  for (double& value : rest) value -= mean;
  return rest;
}

/// The longest stretch over which the mode keeps enough of its amplitude.
TaperedWindow stretch_of(std::span<const double> signal, double rate, double frequency) {
  constexpr double kKept = 0.4;
  constexpr double kMostPeriods = 400.0;
  const double duration = static_cast<double>(signal.size() - 1) / rate;
  const auto window = [&](double length) {
    return TaperedWindow(signal, rate, length / 2.0, length);
  };
  const auto height = [&](double length) {
    const double near = 2.0 * std::numbers::pi * kNear / length;
    const double omega = 2.0 * std::numbers::pi * frequency;
    const TaperedWindow tapered = window(length);
    return std::abs(tapered.transform(tapered.strongest(omega - near, omega + near)));
  };
  double length = std::min(duration, kLeastPeriods / frequency);
  const double first = height(length);
  constexpr double kGrowth = 1.25;
  while (length * kGrowth <= std::min(duration, kMostPeriods / frequency) &&
         height(length * kGrowth) >= kKept * first) {
    length *= kGrowth;
  }
  return window(length);
}

/// Local maxima of a spectrum that are parted from what is higher.
class PeakFinder {
 public:
  /// @param line  Hz, from value to value. @param resolution  values a line of the window, 1/T.
  PeakFinder(std::vector<double> magnitude, double line, double resolution)
      : magnitude_(std::move(magnitude)), line_(line), resolution_(resolution) {}

  /// @param mode  Hz.
  [[nodiscard]] std::vector<SpectralPeak> beside(double mode) const {
    constexpr double kOwn = 4.0;      // lines about the mode that are its own
    constexpr double kLeast = 0.002;  // of the mode's height
    constexpr double kValley = 1.0 / 3.0;
    const double own = highest_near(mode, kNear);
    std::vector<SpectralPeak> peaks;
    if (!(own > 0.0)) return peaks;
    for (std::size_t i = 2; i + 2 < magnitude_.size(); ++i) {
      if (magnitude_[i] < magnitude_[i - 1] || magnitude_[i] <= magnitude_[i + 1]) continue;
      const double frequency = line_ * static_cast<double>(i);
      if (std::abs(frequency - mode) < kOwn * resolution_ * line_) continue;
      if (magnitude_[i] < kLeast * own || !parted(i, kValley) || !above_noise(i)) continue;
      peaks.push_back({frequency, magnitude_[i] / own});
    }
    return above_leakage(std::move(peaks), mode);
  }

  [[nodiscard]] std::vector<SpectralPeak> all() const {
    // A weak mode lies on the skirts of strong ones: it counts where it has a half-power width.
    constexpr double kHalfPower = std::numbers::sqrt2 / 2.0;
    const double highest = *std::ranges::max_element(magnitude_);
    std::vector<SpectralPeak> peaks;
    for (std::size_t i = 1; i + 1 < magnitude_.size(); ++i) {
      if (magnitude_[i] < magnitude_[i - 1] || magnitude_[i] <= magnitude_[i + 1]) continue;
      if (!parted(i, kHalfPower)) continue;
      peaks.push_back({line_ * static_cast<double>(i), magnitude_[i] / highest});
    }
    return peaks;
  }

 private:
  [[nodiscard]] double highest_near(double frequency, double lines) const {
    const double last = static_cast<double>(magnitude_.size() - 1);
    const double reach = lines * resolution_;
    const double centre = frequency / line_;
    const auto from = static_cast<std::size_t>(std::clamp(centre - reach, 0.0, last));
    const auto to = static_cast<std::size_t>(std::clamp(centre + reach, 0.0, last));
    return *std::max_element(magnitude_.begin() + static_cast<std::ptrdiff_t>(from),
                             magnitude_.begin() + static_cast<std::ptrdiff_t>(to) + 1);
  }

  /// Whether the spectrum falls to a share on both sides before it rises above the peak.
  [[nodiscard]] bool parted(std::size_t peak, double share) const {
    const double height = magnitude_[peak];
    const auto falls = [&](std::ptrdiff_t direction) {
      for (auto i = static_cast<std::ptrdiff_t>(peak) + direction;
           i >= 0 && i < static_cast<std::ptrdiff_t>(magnitude_.size()); i += direction) {
        const double value = magnitude_[static_cast<std::size_t>(i)];
        if (value > height) return false;
        if (value < share * height) return true;
      }
      return direction > 0;  // a peak at 0 Hz is an offset or a drift
    };
    return falls(-1) && falls(+1);
  }

  /// Of a thousand lines of noise none is five times the median of those about it.
  [[nodiscard]] bool above_noise(std::size_t peak) const {
    constexpr double kAbove = 5.0;
    constexpr double kLines = 40.0;
    const auto reach = static_cast<std::size_t>(kLines * resolution_);
    const std::size_t from = peak - std::min(peak, reach);
    const std::size_t to = std::min(peak + reach, magnitude_.size());
    const auto first = magnitude_.begin();
    return magnitude_[peak] > kAbove * median({first + static_cast<std::ptrdiff_t>(from),
                                               first + static_cast<std::ptrdiff_t>(to)});
  }

  /// A side lobe of the taper is no oscillation.
  [[nodiscard]] std::vector<SpectralPeak> above_leakage(std::vector<SpectralPeak> peaks,
                                                        double mode) const {
    constexpr double kSure = 3.0;
    std::vector<SpectralPeak> all = peaks;
    all.push_back({mode, 1.0});
    std::erase_if(peaks, [&](const SpectralPeak& peak) {
      return std::ranges::any_of(all, [&](const SpectralPeak& other) {
        const double d = std::abs(other.frequency - peak.frequency) / (resolution_ * line_);
        if (other.height <= peak.height || d < 1.0) return false;
        const double lobe = d < 3.0 ? 0.02 : side_lobe(d);
        return peak.height < kSure * lobe * other.height;
      });
    });
    return peaks;
  }

  std::vector<double> magnitude_;
  double line_;
  double resolution_;
};

/// Keeps the peaks that disturb the mode most in the shortest window.
void keep_the_worst(std::vector<SpectralPeak>& peaks, double mode) {
  constexpr std::size_t kMost = 12;
  if (peaks.size() <= kMost) return;
  const auto disturbs = [&](const SpectralPeak& peak) {
    const BesideMode beside{std::abs(peak.frequency - mode), peak.height};
    return decay_leakage({&beside, 1}, kLeastPeriods / mode);
  };
  std::ranges::sort(peaks, std::greater{}, disturbs);
  peaks.resize(kMost);
  std::ranges::sort(peaks, std::less{}, &SpectralPeak::frequency);
}

}  // namespace

double find_mode(std::span<const double> signal, double rate, double from, double to) {
  const std::vector<double> magnitude =
      magnitudes(without_mean(signal), std::bit_ceil(2 * signal.size()));
  const double line = 0.5 * rate / static_cast<double>(magnitude.size() - 1);
  const double last = static_cast<double>(magnitude.size()) - 2.0;
  const auto first = static_cast<std::size_t>(std::clamp(std::ceil(from / line), 1.0, last));
  const auto end = static_cast<std::size_t>(std::clamp(std::floor(to / line), 1.0, last));
  if (end < first) return 0.0;
  const auto begin = magnitude.begin();
  const auto highest = std::max_element(begin + static_cast<std::ptrdiff_t>(first),
                                        begin + static_cast<std::ptrdiff_t>(end) + 1);
  if (!(*highest > 0.0)) return 0.0;
  return line * static_cast<double>(highest - begin);
}

std::vector<SpectralPeak> parted_peaks(std::span<const double> signal, double rate) {
  std::vector<double> values = without_mean(signal);
  const double step = 0.5 * std::numbers::pi / static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double cosine = std::cos(step * static_cast<double>(i));
    values[i] *= cosine * cosine;
  }
  std::vector<double> magnitude = magnitudes(std::move(values), std::bit_ceil(2 * signal.size()));
  const double line = 0.5 * rate / static_cast<double>(magnitude.size() - 1);
  return PeakFinder(std::move(magnitude), line, 1.0).all();
}

ModeNeighbours neighbours_of(std::span<const double> signal, double rate, double frequency) {
  const TaperedWindow window = stretch_of(signal, rate, frequency);
  std::vector<double> tapered(window.size());
  for (std::size_t i = 0; i < tapered.size(); ++i) tapered[i] = window.weight(i) * window.value(i);
  constexpr std::size_t kDense = 8;  // lines of the FFT for one of the window
  std::vector<double> magnitude =
      magnitudes(std::move(tapered), std::bit_ceil(kDense * window.size()));
  const double line = 0.5 * rate / static_cast<double>(magnitude.size() - 1);
  const PeakFinder finder(std::move(magnitude), line, 1.0 / (window.length() * line));
  ModeNeighbours found{.peaks = finder.beside(frequency), .length = window.length()};
  keep_the_worst(found.peaks, frequency);
  return found;
}

}  // namespace microslip
