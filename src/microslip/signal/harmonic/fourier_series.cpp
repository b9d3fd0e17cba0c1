// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/fourier_series.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;

/// Σ_k a_k P_k(s), k from 1, by the recurrence (k + 1) P_{k+1} = (2k + 1) s P_k − k P_{k−1}.
double legendre_sum(const std::vector<double>& a, double s) {
  double before = 1.0;
  double here = s;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * here;
    const double k = static_cast<double>(i) + 1.0;
    const double next = ((2.0 * k + 1.0) * s * here - k * before) / (k + 1.0);
    before = here;
    here = next;
  }
  return sum;
}

/// Horner's rule in e^{iωt}: one sine and one cosine whatever the order.
double harmonic_sum(const std::vector<Complex>& c, Complex rotation) {
  Complex sum = 0.0;
  for (std::size_t i = c.size(); i-- > 0;) sum = (sum + c[i]) * rotation;
  return sum.real();
}

}  // namespace

double FourierSeries::frequency() const { return omega / (2.0 * std::numbers::pi); }

double FourierSeries::period() const { return 2.0 * std::numbers::pi / omega; }

double FourierSeries::value(double t) const {
  const double s = (t - trend_centre) / trend_half_width;
  return mean + legendre_sum(trend, s) + periodic_value(t);
}

double FourierSeries::periodic_value(double t) const {
  return harmonic_sum(harmonic, std::polar(1.0, omega * t));
}

FourierSeries derivative(const FourierSeries& series) {
  FourierSeries result = series;
  result.mean = 0.0;
  result.trend.assign(series.trend.empty() ? 0 : series.trend.size() - 1, 0.0);
  // P_k′ = (2k − 1) P_{k−1} + (2k − 5) P_{k−3} + …, the last of them P_1 or P_0.
  for (std::size_t k = 1; k <= series.trend.size(); ++k) {
    const double slope = series.trend[k - 1] / series.trend_half_width;
    for (std::size_t below = 1; below <= k; below += 2) {
      const std::size_t degree = k - below;
      const double part = slope * (2.0 * static_cast<double>(degree) + 1.0);
      (degree == 0 ? result.mean : result.trend[degree - 1]) += part;
    }
  }
  for (std::size_t n = 1; n <= series.order(); ++n) {
    result.harmonic[n - 1] *= Complex(0.0, static_cast<double>(n) * series.omega);
  }
  return result;
}

FourierSeries integral(const FourierSeries& series) {
  if (!(series.omega > 0.0)) {
    throw InputError("omega of the series to integrate", series.omega, "must be above 0");
  }
  FourierSeries result = series;
  result.mean = 0.0;
  result.trend.clear();
  for (std::size_t n = 1; n <= series.order(); ++n) {
    result.harmonic[n - 1] /= Complex(0.0, static_cast<double>(n) * series.omega);
  }
  return result;
}

FourierSeries shifted(const FourierSeries& series, double origin) {
  FourierSeries result = series;
  result.trend_centre -= origin;
  for (std::size_t n = 1; n <= series.order(); ++n) {
    result.harmonic[n - 1] *= std::polar(1.0, static_cast<double>(n) * series.omega * origin);
  }
  return result;
}

double rms(const FourierSeries& series, std::size_t first) {
  double sum = 0.0;
  for (std::size_t n = first; n <= series.order(); ++n) sum += std::norm(series.c(n));
  return std::sqrt(0.5 * sum);
}

std::vector<double> values(const FourierSeries& series, const Axis& axis, std::size_t points) {
  std::vector<double> result(points);
  for (std::size_t i = 0; i < points; ++i) result[i] = series.value(axis.at(i));
  return result;
}

}  // namespace microslip
