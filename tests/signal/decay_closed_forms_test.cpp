// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "microslip/signal/decay/decay_leakage.hpp"
#include "microslip/signal/decay/decay_spread.hpp"
#include "microslip/signal/decay/decay_window.hpp"

/// Closed forms and figures of the fit under cos⁴(πt), |t| < ½, against quadrature.

namespace microslip::decay_closed_forms_test {
namespace {

/// Over |t| < half by the trapezoidal rule: at the ends the integrands vanish with three
/// derivatives, and 4000 intervals leave less than 1e−10.
double integral(const std::function<double(double)>& f, double half) {
  constexpr int kIntervals = 4000;
  const double h = 2.0 * half / kIntervals;
  double sum = 0.0;
  for (int i = 0; i <= kIntervals; ++i) {
    sum += (i == 0 || i == kIntervals ? 0.5 : 1.0) * f(-half + h * i);
  }
  return h * sum;
}

double taper(double t) {
  return std::abs(t) < 0.5 ? std::pow(std::cos(std::numbers::pi * t), 4) : 0.0;
}

double moment(int power) {
  return integral([=](double t) { return std::pow(t, power) * taper(t); }, 0.5);
}

TEST(DecayClosedForms, TheVarianceOfTheDecayIsThatOfItsEstimator) {
  const double squares = integral([](double t) { return t * t * taper(t) * taper(t); }, 0.5);
  EXPECT_NEAR(kDecayVariance, squares / (moment(2) * moment(2)), 1e-3);
}

TEST(DecayClosedForms, LeakageIsWhatAnotherOscillationMovesTheDecayBy) {
  // At whole lines, where the bound is reached: r∫t cos⁴πt sin 2πdt dt/∫t² cos⁴πt dt.
  for (const int d : {3, 4, 5, 6, 8, 12}) {
    const double moved =
        std::abs(integral(
            [=](double t) { return t * taper(t) * std::sin(2.0 * std::numbers::pi * d * t); },
            0.5)) /
        moment(2);
    const BesideMode other{.distance = static_cast<double>(d), .ratio = 0.1};
    EXPECT_NEAR(decay_leakage({&other, 1}, 1.0) / (0.1 * moved), 1.0, 2e-3) << d;
  }
}

/// Σ(b − b′)²/Σb², b′ that of a window of another length: b scaled in time, and by the power of the
/// length that keeps its meaning.
double difference(const std::function<double(double)>& b, double factor, int power) {
  const double half = 0.5 * std::max(1.0, factor);
  const auto other = [&](double t) { return b(t / factor) / std::pow(factor, power); };
  return integral([&](double t) { return std::pow(b(t) - other(t), 2); }, half) /
         integral([&](double t) { return b(t) * b(t); }, half);
}

TEST(DecayClosedForms, NoiseMakesTheLengthsDifferByTheirShares) {
  // Rows of the inverse of the normal equations: of 1 beside t², of t alone, and of t beside t³.
  const double m2 = moment(2);
  const double m4 = moment(4);
  const double m6 = moment(6);
  const auto level = [&](double t) { return (m4 - m2 * t * t) * taper(t); };
  const auto decay = [](double t) { return t * taper(t); };
  const auto frequency = [&](double t) { return (m6 - m4 * t * t) * t * taper(t); };
  for (const OtherLength& length : kOtherLengths) {
    EXPECT_NEAR(length.level, difference(level, length.factor, 1), 5.1e-4) << length.factor;
    EXPECT_NEAR(length.decay, difference(decay, length.factor, 2), 5.1e-4) << length.factor;
    EXPECT_NEAR(length.frequency, difference(frequency, length.factor, 2), 5.1e-4) << length.factor;
  }
}

}  // namespace
}  // namespace microslip::decay_closed_forms_test
