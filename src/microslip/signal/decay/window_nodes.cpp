// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/window_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr std::size_t kPolynomials = 8;
constexpr std::size_t kBefore = 3;       // nodes before the interval of a sample that it counts at
constexpr std::size_t kAboutMode = 128;  // nodes: 8 for one of the 16 lines
constexpr double kFewestPeriods = 20.0;  // 40 lines from the term of twice the frequency
constexpr double kNodesOfPeriod = 24.0;  // of real nodes
constexpr double kNodesOfLine = 8.0;
constexpr double kWorthwhile = 3.0;  // samples for a node

/// Lagrange's polynomials of the nodes −3, …, 4 at t from 0 to 1.
std::array<double, kPolynomials> polynomials_at(double t) {
  // 1/∏(j − i) over i ≠ j
  constexpr std::array<double, kPolynomials> kScale{-1.0 / 5040.0, 1.0 / 720.0,  -1.0 / 240.0,
                                                    1.0 / 144.0,   -1.0 / 144.0, 1.0 / 240.0,
                                                    -1.0 / 720.0,  1.0 / 5040.0};
  std::array<double, kPolynomials> below{};
  double product = 1.0;
  for (std::size_t j = 0; j < kPolynomials; ++j) {
    below[j] = product * kScale[j];
    product *= t + static_cast<double>(kBefore) - static_cast<double>(j);
  }
  product = 1.0;
  for (std::size_t j = kPolynomials; j-- > 0;) {
    below[j] *= product;
    product *= t + static_cast<double>(kBefore) - static_cast<double>(j);
  }
  return below;
}

}  // namespace

WindowNodes::WindowNodes(const TaperedWindow& window, double from, double to)
    : length_(window.length()) {
  const double line = 2.0 * std::numbers::pi / window.length();
  const auto samples = static_cast<double>(window.size());
  const auto worthwhile = [&](double nodes) { return samples >= kWorthwhile * nodes; };
  if (from < kFewestPeriods * line) {
    const double nodes = std::ceil(kNodesOfPeriod * to / line);
    if (worthwhile(nodes)) {
      take_nodes(window, 0.0, static_cast<std::size_t>(nodes));
      highest_ = to + kReach * line;
    } else {
      take_samples(window);
    }
    strongest_ = strongest_between(from, to);
    return;
  }
  // Twice: coarsely over all of the range, and then about the mode.
  const double reach = 0.5 * (to - from) / line + 4.0;
  const double nodes = std::max(static_cast<double>(kAboutMode), std::ceil(kNodesOfLine * reach));
  if (worthwhile(nodes)) {
    take_nodes(window, 0.5 * (from + to), static_cast<std::size_t>(nodes));
  } else {
    take_samples(window);
  }
  strongest_ = strongest_between(from, to);
  if (worthwhile(static_cast<double>(kAboutMode))) take_nodes(window, strongest_, kAboutMode);
}

void WindowNodes::take_samples(const TaperedWindow& window) {
  const std::size_t n = window.size();
  place_.resize(n);
  weight_.resize(n);
  value_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    place_[i] = window.place(i);
    weight_[i] = window.weight(i);
    value_[i] = window.value(i);
  }
  carrier_ = 0.0;
  samples_ = 1.0;
}

void WindowNodes::take_nodes(const TaperedWindow& window, double carrier, std::size_t count) {
  carrier_ = carrier;
  const auto intervals = static_cast<double>(count);
  const double half = 0.5 * length_;
  const double step = window.size() > 1 ? window.place(1) - window.place(0) : 1.0;
  // Node k is entry k + kPolynomials, so that those beyond the ends of the window have a place.
  std::vector<double> real(count + 2 * kPolynomials + 1, 0.0);
  std::vector<double> imaginary(real.size(), 0.0);
  const std::complex<double> turn = std::polar(1.0, -carrier * step * half);
  const std::complex<double> start = std::polar(1.0, -carrier * window.place(0) * half);
  double cosine = start.real();
  double sine = start.imag();
  for (std::size_t i = 0; i < window.size(); ++i) {
    const double at = 0.5 * (window.place(i) + 1.0) * intervals;
    const double floor = std::floor(at);
    const auto first = static_cast<std::size_t>(floor + (kPolynomials - kBefore));
    const std::array<double, kPolynomials> share = polynomials_at(at - floor);
    const double value = window.weight(i) * window.value(i);
    const double a = value * cosine;
    const double b = value * sine;
    for (std::size_t j = 0; j < kPolynomials; ++j) {
      real[first + j] += share[j] * a;
      imaginary[first + j] += share[j] * b;
    }
    const double turned = cosine * turn.real() - sine * turn.imag();
    sine = cosine * turn.imag() + sine * turn.real();
    cosine = turned;
  }
  // The samples of an interval between nodes.
  const double dense = 2.0 / (step * intervals);
  samples_ = is_complex() ? 0.5 * dense : dense;
  place_.clear();
  weight_.clear();
  value_.clear();
  for (std::size_t k = 1; k < count; ++k) {
    const double place = 2.0 * static_cast<double>(k) / intervals - 1.0;
    const double weight = taper(place);
    place_.push_back(place);
    weight_.push_back(weight);
    const double scale = 1.0 / (samples_ * weight);
    value_.emplace_back(scale * real[k + kPolynomials], scale * imaginary[k + kPolynomials]);
  }
}

template <typename Weight>
std::complex<double> WindowNodes::sum_of(const std::vector<std::complex<double>>& values,
                                         double omega, const Weight& weight) const {
  const double half = 0.5 * length_;
  const double apart = place_.size() > 1 ? place_[1] - place_[0] : 0.0;
  const std::complex<double> turn = std::polar(1.0, -(omega - carrier_) * apart * half);
  const std::complex<double> start = std::polar(1.0, -(omega - carrier_) * place_.front() * half);
  double cosine = start.real();
  double sine = start.imag();
  double real = 0.0;
  double imaginary = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double w = weight(k);
    weights += w;
    real += w * (values[k].real() * cosine - values[k].imag() * sine);
    imaginary += w * (values[k].real() * sine + values[k].imag() * cosine);
    const double turned = cosine * turn.real() - sine * turn.imag();
    sine = cosine * turn.imag() + sine * turn.real();
    cosine = turned;
  }
  const double share = is_complex() ? 0.5 : 1.0;
  return share / weights * std::complex<double>(real, imaginary);
}

std::complex<double> WindowNodes::transform(const std::vector<std::complex<double>>& values,
                                            double omega) const {
  return sum_of(values, omega, [&](std::size_t k) { return weight_[k]; });
}

std::complex<double> WindowNodes::half_transform(int which, double omega) const {
  const double centre = which == 0 ? -0.5 : 0.5;
  return sum_of(value_, omega, [&](std::size_t k) {
    const double place = 2.0 * (place_[k] - centre);
    return std::abs(place) >= 1.0 ? 0.0 : taper(place);
  });
}

double WindowNodes::strongest_between(double from, double to) const {
  return strongest_of(from, to, length_, [&](double omega) { return transform(value_, omega); });
}

bool WindowNodes::holds(double omega) const {
  if (is_complex()) {
    return std::abs(omega - carrier_) <= kReach * 2.0 * std::numbers::pi / length_;
  }
  return highest_ == 0.0 || omega <= highest_;
}

}  // namespace microslip
