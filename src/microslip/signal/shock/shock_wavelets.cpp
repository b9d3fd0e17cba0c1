// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/shock_wavelets.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "microslip/base/random.hpp"

namespace microslip {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double kFewestHalfCycles = 3.0;  // one alone has a net displacement
constexpr double kMostHalfCycles = 15.0;
constexpr double kWholeHalfCycles = 1e-9;

/// The largest odd number that fits into the length.
double half_cycles(double frequency, double length) {
  const double fit = std::floor(2.0 * frequency * length * (1.0 + kWholeHalfCycles));
  const double odd = fit - (std::fmod(fit, 2.0) == 0.0 ? 1.0 : 0.0);
  return std::clamp(odd, kFewestHalfCycles, kMostHalfCycles);
}

std::vector<double> wavelet_values(std::size_t steps, double half_cycles) {
  std::vector<double> values;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double turn = pi * static_cast<double>(i) / static_cast<double>(steps);
    values.push_back(std::sin(turn) * std::sin(half_cycles * turn));
  }
  values.back() = 0.0;
  return values;
}

/// Where the absolute acceleration of a mass on a shaken base is Re(c ∫ e^{λ(t−s)} a(s) ds).
struct Kernel {
  Kernel(double frequency, double zeta) {
    const double omega = 2.0 * pi * frequency;
    lambda = {-zeta * omega, omega * std::sqrt(1.0 - zeta * zeta)};
    c = {2.0 * zeta * omega, -omega * omega * (1.0 - 2.0 * zeta * zeta) / lambda.imag()};
  }
  Complex lambda;
  Complex c;
};

}  // namespace

ShockWavelets::ShockWavelets(const std::vector<double>& frequency, std::size_t steps,
                             double sampling_rate, std::uint64_t seed, std::uint64_t draw)
    : step_(1.0 / sampling_rate),
      times_(steps + 1),
      sign_(static_cast<Eigen::Index>(frequency.size())) {
  RandomStream random(seed, draw);
  const double length = static_cast<double>(steps) * step_;
  for (std::size_t k = 0; k < frequency.size(); ++k) {
    const double cycles = half_cycles(frequency[k], length);
    const auto own =
        static_cast<std::size_t>(std::lround(0.5 * cycles * sampling_rate / frequency[k]));
    const std::size_t m = std::min(own, steps);
    const double early = random.uniform();
    const double room = static_cast<double>(steps - m);
    wavelets_.push_back(
        {static_cast<std::size_t>(early * early * room), wavelet_values(m, cycles)});
    sign_[static_cast<Eigen::Index>(k)] = random.uniform() < 0.5 ? -1.0 : 1.0;
  }
}

std::vector<double> ShockWavelets::sum(const Eigen::VectorXd& amplitude) const {
  std::vector<double> a(times_, 0.0);
  for (std::size_t k = 0; k < wavelets_.size(); ++k) {
    const ShockWavelet& wavelet = wavelets_[k];
    for (std::size_t i = 0; i < wavelet.values.size(); ++i) {
      a[wavelet.begin + i] += amplitude[static_cast<Eigen::Index>(k)] * wavelet.values[i];
    }
  }
  return a;
}

ShockWavelets::Peak ShockWavelets::peak(const std::vector<double>& acceleration, double frequency,
                                        double damping_ratio) const {
  const Kernel kernel(frequency, damping_ratio);
  const Complex turn = std::exp(kernel.lambda * step_);
  const std::size_t last = times_ + static_cast<std::size_t>(1.0 / (frequency * step_));
  Peak peak;
  std::size_t at = 0;
  Complex state = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    state = turn * state + (i < times_ ? step_ * acceleration[i] : 0.0);
    const double response = (kernel.c * state).real();
    if (std::abs(response) <= std::abs(peak.value)) continue;
    peak.value = response;
    at = i;
  }
  // Response at the time of the peak to a unit acceleration at each time.
  std::vector<double> share(times_, 0.0);
  const std::size_t top = std::min(at, times_ - 1);
  Complex back =
      step_ * kernel.c * std::exp(kernel.lambda * (step_ * static_cast<double>(at - top)));
  for (std::size_t i = top + 1; i-- > 0; back *= turn) share[i] = back.real();
  peak.derivative.setZero(static_cast<Eigen::Index>(wavelets_.size()));
  for (std::size_t k = 0; k < wavelets_.size(); ++k) {
    const ShockWavelet& wavelet = wavelets_[k];
    double sum = 0.0;
    for (std::size_t i = 0; i < wavelet.values.size(); ++i) {
      sum += share[wavelet.begin + i] * wavelet.values[i];
    }
    peak.derivative[static_cast<Eigen::Index>(k)] = sum;
  }
  return peak;
}

}  // namespace microslip
