// SPDX-License-Identifier: MIT
#include "microslip/signal/mode_peak.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace microslip {
namespace {

constexpr double kNearest = 0.06;    // of the frequency: what is nearer is the mode's own
constexpr double kSmoothing = 0.02;  // of the frequency

/// Magnitudes of the lines 0 to half the sampling rate; zeros behind the record fill it to a power of 2.
std::vector<double> magnitudes(std::span<const double> signal) {
  std::vector<double> padded(signal.begin(), signal.end());
  const double mean =
      std::accumulate(padded.begin(), padded.end(), 0.0) / static_cast<double>(padded.size());
  for (double& value : padded) value -= mean;
  padded.resize(std::bit_ceil(2 * padded.size()), 0.0);
  std::vector<std::complex<double>> lines;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  fft.fwd(lines, padded);
  std::vector<double> magnitude(lines.size());
  std::ranges::transform(lines, magnitude.begin(),
                         [](const std::complex<double>& line) { return std::abs(line); });
  return magnitude;
}

/// Root mean square over `width` lines: a mode whose frequency moves has a rippled spectrum.
std::vector<double> smoothed(const std::vector<double>& magnitude, std::size_t width) {
  std::vector<double> sum(magnitude.size() + 1, 0.0);
  for (std::size_t i = 0; i < magnitude.size(); ++i) {
    sum[i + 1] = sum[i] + magnitude[i] * magnitude[i];
  }
  std::vector<double> smooth(magnitude.size());
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    const std::size_t from = i - std::min(i, width / 2);
    const std::size_t to = std::min(i + width / 2 + 1, smooth.size());
    smooth[i] = std::sqrt((sum[to] - sum[from]) / static_cast<double>(to - from));
  }
  return smooth;
}

/// The peaks on one side of the main one, walking away from it.
void add_neighbours(const std::vector<double>& smooth, std::size_t main, int direction, double line,
                    std::vector<SpectralPeak>& peaks) {
  constexpr double kLowest = 0.03;
  constexpr double kValley = 1.0 / 3.0;
  const auto last = static_cast<std::ptrdiff_t>(smooth.size()) - 2;
  const auto centre = static_cast<std::ptrdiff_t>(main);
  const auto nearest = static_cast<std::ptrdiff_t>(kNearest * static_cast<double>(main));
  const auto at = [&](std::ptrdiff_t i) { return smooth[static_cast<std::size_t>(i)]; };
  double valley = at(centre);
  SpectralPeak highest;
  for (std::ptrdiff_t i = centre + direction * nearest;
       i > centre / 3 && i < std::min(5 * centre / 3, last); i += direction) {
    valley = std::min(valley, at(i));
    const double height = at(i) / at(centre);
    const bool parted = valley < kValley * at(i) && height >= kLowest;
    if (parted && height > highest.height) highest = {line * static_cast<double>(i), height};
    // Down again from that peak: the next one counts by itself.
    if (highest.height > 0.0 && height < kValley * highest.height) {
      peaks.push_back(highest);
      highest = {};
      valley = at(i);
    }
  }
}

}  // namespace

ModePeak find_mode(std::span<const double> signal, double rate, double from, double to) {
  const std::vector<double> magnitude = magnitudes(signal);
  const double line = 0.5 * rate / static_cast<double>(magnitude.size() - 1);
  const double last = static_cast<double>(magnitude.size()) - 2.0;
  const auto first = static_cast<std::size_t>(std::clamp(std::ceil(from / line), 1.0, last));
  const auto end = static_cast<std::size_t>(std::clamp(std::floor(to / line), 1.0, last));
  if (end < first) return {};
  const auto begin = magnitude.begin();
  const auto highest = std::max_element(begin + static_cast<std::ptrdiff_t>(first),
                                        begin + static_cast<std::ptrdiff_t>(end) + 1);
  if (!(*highest > 0.0)) return {};
  const auto main = static_cast<std::size_t>(highest - begin);
  ModePeak peak{.frequency = line * static_cast<double>(main), .neighbours = {}};
  const std::vector<double> smooth =
      smoothed(magnitude, static_cast<std::size_t>(kSmoothing * static_cast<double>(main)));
  add_neighbours(smooth, main, -1, line, peak.neighbours);
  std::ranges::reverse(peak.neighbours);
  add_neighbours(smooth, main, +1, line, peak.neighbours);
  return peak;
}

}  // namespace microslip
