// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/tapered_transform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {

double taper(double place) {
  const double cosine = std::cos(0.5 * std::numbers::pi * place);
  return cosine * cosine * cosine * cosine;
}

TaperedWindow::TaperedWindow(std::span<const double> signal, double rate, double centre,
                             double length)
    : length_(length), rate_(rate), step_(2.0 / (length * rate)) {
  const double last = static_cast<double>(signal.size()) - 1.0;
  const double from = std::clamp(std::ceil((centre - length / 2.0) * rate), 0.0, last);
  const double to = std::clamp(std::floor((centre + length / 2.0) * rate), from, last);
  values_ = signal.subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from) + 1);
  first_ = (from / rate - centre) * 2.0 / length;
  weights_.resize(values_.size());
  for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = taper(place(i));
}

double TaperedWindow::largest() const {
  double most = 0.0;
  for (const double value : values_) most = std::max(most, std::abs(value));
  return most;
}

std::complex<double> TaperedWindow::transform(double omega) const {
  // A rotating phasor in place of a cosine per sample; over a window its rounding stays below
  // 1e−12. In real numbers, for a product of complex ones looks for NaN each time.
  const std::complex<double> start = std::polar(1.0, -omega * first_ * length_ / 2.0);
  const std::complex<double> step = std::polar(1.0, -omega / rate_);
  double real = start.real();
  double imaginary = start.imag();
  std::complex<double> sum = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double value = weights_[i] * values_[i];
    sum += std::complex<double>(value * real, value * imaginary);
    weight += weights_[i];
    const double turned = real * step.real() - imaginary * step.imag();
    imaginary = real * step.imag() + imaginary * step.real();
    real = turned;
  }
  return sum / weight;
}

double TaperedWindow::noise_gain() const {
  double sum = 0.0;
  double squares = 0.0;
  for (const double weight : weights_) {
    sum += weight;
    squares += weight * weight;
  }
  return squares / (sum * sum);
}

double TaperedWindow::strongest(double from, double to) const {
  return strongest_of(from, to, length_, [&](double omega) { return transform(omega); });
}

}  // namespace microslip
