// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/load_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/base/work_size.hpp"
#include "microslip/signal/shock/log_log_line.hpp"

namespace microslip {
namespace {

using std::numbers::pi;

/// Memory of a time with its loads, and of its line in a table, bytes.
constexpr double kBytesOfTime = 85.0;
/// Fewest lines of noise within its density: the variance of one signal is then known to some
/// √(2/64).
constexpr double kLeastLines = 64.0;
constexpr std::size_t kLargestTransform = std::size_t{1} << 26U;
/// A duration that is a whole number of steps, to rounding, ends with one.
constexpr double kWholeSteps = 1e-9;

void require_above_zero(const char* what, double value) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw InputError(what, value, "must be positive and finite");
  }
}

/// Longer than the signal, which repeats after that, and with enough lines in the density.
std::size_t transform_size(std::size_t count, double sampling_rate, const PowerDensity& density) {
  const double lowest = density.frequency.front();
  const double width = density.frequency.back() - lowest;
  const double step = std::min(width / kLeastLines, lowest / 2.0);
  std::size_t size = 2;
  while (size < count || sampling_rate > step * static_cast<double>(size)) {
    size *= 2;
    if (size <= kLargestTransform) continue;
    throw InputError("sampling rate", sampling_rate,
                     fmt::format("must be lower, or the density wider than {:g} Hz and from above "
                                 "{:g} Hz: its noise needs more than {} values",
                                 width, lowest, kLargestTransform));
  }
  return size;
}

}  // namespace

std::vector<double> even_times(double duration, double sampling_rate) {
  require_above_zero("duration", duration);
  require_above_zero("sampling rate", sampling_rate);
  const double steps = std::floor(duration * sampling_rate * (1.0 + kWholeSteps));
  if (!(steps >= 1.0)) {
    throw InputError("number of times", steps + 1.0, "must be 2 or more",
                     "Change the duration or the sampling rate.");
  }
  check_memory("number of times", steps + 1.0, kBytesOfTime,
               "Change the duration or the sampling rate.");
  std::vector<double> time(static_cast<std::size_t>(steps) + 1);
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = static_cast<double>(i) / sampling_rate;
  return time;
}

std::vector<double> sine_burst(std::span<const double> time,
                               std::span<const std::complex<double>> harmonics, double frequency,
                               double end) {
  require_above_zero("frequency", frequency);
  std::vector<double> values;
  values.reserve(time.size());
  for (const double t : time) {
    double sum = 0.0;
    for (std::size_t n = 0; n < harmonics.size() && t < end; ++n) {
      const double turn = 2.0 * pi * static_cast<double>(n + 1) * frequency * t;
      sum += std::real(harmonics[n] * std::polar(1.0, turn));
    }
    values.push_back(sum);
  }
  return values;
}

std::vector<double> sine_sweep(std::span<const double> time, double from, double to,
                               bool logarithmic) {
  require_above_zero("first frequency of a sweep", from);
  require_above_zero("last frequency of a sweep", to);
  if (from == to) throw InputError("last frequency of a sweep", to, "must differ from the first");
  const double length = time.back() - time.front();
  const double ratio = std::log(to / from);
  std::vector<double> values;
  values.reserve(time.size());
  for (const double t : time) {
    const double share = (t - time.front()) / length;
    const double turns = logarithmic ? from * length * std::expm1(ratio * share) / ratio
                                     : length * share * (from + 0.5 * share * (to - from));
    values.push_back(std::sin(2.0 * pi * turns));
  }
  return values;
}

std::vector<double> half_sine(std::span<const double> time, double begin, double duration) {
  require_above_zero("duration of a pulse", duration);
  std::vector<double> values;
  values.reserve(time.size());
  for (const double t : time) {
    const double share = (t - begin) / duration;
    values.push_back(share > 0.0 && share < 1.0 ? std::sin(pi * share) : 0.0);
  }
  return values;
}

void PowerDensity::check() const {
  check_log_log_line("a power density", "density", frequency, density);
}

double PowerDensity::at(double f) const { return log_log_value(frequency, density, f); }

double PowerDensity::rms() const {
  double area = 0.0;
  for (std::size_t k = 1; k < frequency.size(); ++k) {
    const double ratio = std::log(frequency[k] / frequency[k - 1]);
    const double slope = std::log(density[k] / density[k - 1]) / ratio;
    const double power = (slope + 1.0) * ratio;  // ∫ S df = S₁f₁ (e^power − 1)/(slope + 1)
    const double part = std::abs(power) < 1e-8 ? ratio : std::expm1(power) / (slope + 1.0);
    area += density[k - 1] * frequency[k - 1] * part;
  }
  return std::sqrt(area);
}

std::vector<double> stationary_noise(std::size_t count, double sampling_rate,
                                     const PowerDensity& density, std::uint64_t seed,
                                     std::uint64_t stream) {
  density.check();
  require_above_zero("sampling rate", sampling_rate);
  if (!(sampling_rate > 2.0 * density.frequency.back())) {
    throw InputError("sampling rate", sampling_rate,
                     fmt::format("must be above twice the highest frequency, {:g} Hz",
                                 density.frequency.back()));
  }
  const std::size_t size = transform_size(count, sampling_rate, density);
  const double step = sampling_rate / static_cast<double>(size);
  std::vector<std::complex<double>> lines(size / 2 + 1);
  RandomStream random(seed, stream);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double scale = std::sqrt(density.at(step * static_cast<double>(k)) * step);
    const double cosine = random.normal();
    const double sine = random.normal();
    lines[k] = 0.5 * scale * std::complex<double>(cosine, -sine);
  }
  lines.back() = 0.0;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  fft.SetFlag(Eigen::FFT<double>::Unscaled);
  std::vector<double> values(size);
  fft.inv(values.data(), lines.data(), static_cast<Eigen::Index>(size));
  values.resize(count);
  return values;
}

}  // namespace microslip
