// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <utility>
#include <vector>

namespace microslip::march_weights_test {
namespace {

using Kind = StepWeights::Kind;
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<200>>;

/// The weights of one mode with 200 digits, of which the recursion upwards in the powers of time
/// may lose a hundred.
std::array<Exact, StepWeights::kKinds> exact_weights(double omega, double eta, double length) {
  const Exact h(length);
  const Exact theta = Exact(omega) * h;
  const Exact delta = theta * Exact(eta) / 2;
  const Exact square = theta * theta;
  const Exact under = delta * delta - square;  // never 0 below
  const Exact root = sqrt(under < 0 ? Exact(-under) : under);
  const Exact up = exp(root);
  const Exact sine = under < 0 ? Exact(sin(root)) : Exact((up - 1 / up) / 2);
  const Exact cosine = under < 0 ? Exact(cos(root)) : Exact((up + 1 / up) / 2);
  const Exact g = exp(-delta) * sine / root;
  const Exact slope = exp(-delta) * cosine - delta * g;
  std::array<Exact, 5> p;
  p[0] = (1 - 2 * delta * g - slope) / square;
  p[1] = (1 - 2 * delta * p[0] - g) / square;
  p[2] = (1 - 4 * delta * p[1] - 2 * p[0]) / square;
  p[3] = (1 - 6 * delta * p[2] - 6 * p[1]) / square;
  p[4] = (1 - 8 * delta * p[3] - 12 * p[2]) / square;
  const auto hermite = [](const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return std::array<Exact, 4>{a - 3 * c + 2 * d, b - 2 * c + d, 3 * c - 2 * d, d - c};
  };
  const auto q = hermite(p[0], p[1], p[2], p[3]);
  const auto v = hermite(g, p[0], 2 * p[1], 3 * p[2]);
  return {slope + 2 * delta * g,
          h * g,
          -square * g / h,
          slope,
          h * h * q[0],
          h * h * h * q[1],
          h * h * q[2],
          h * h * h * q[3],
          h * v[0],
          h * h * v[1],
          h * v[2],
          h * h * v[3],
          16 * h * h * (p[2] - 2 * p[3] + p[4]),
          16 * h * (2 * p[1] - 6 * p[2] + 4 * p[3])};
}

/// Largest error of the weights of the loads, over the larger of those at both ends; of those of
/// the slopes on the velocity, which all but vanish in a slow motion, over h times that of the
/// load.
double largest_error(double eta, double theta) {
  constexpr double kLength = 0.01;
  const Mode mode{theta / kLength, eta};
  StepWeights weights(std::vector<Mode>{mode});
  weights.set_length(kLength);
  const auto exact = exact_weights(mode.angular_frequency, eta, kLength);
  const auto error = [&](Kind kind, Kind scale) {
    const bool shares = kind != Kind::kD0 && kind != Kind::kD1;
    const Exact other = abs(exact[scale]) * (shares ? 1.0 : kLength);
    const Exact size = abs(exact[kind]) > other ? abs(exact[kind]) : other;
    return static_cast<double>(abs(Exact(weights(kind, 0)) - exact[kind]) / size);
  };
  double largest = 0.0;
  for (const auto& [kind, scale] : {std::pair{Kind::kA0, Kind::kA1},
                                    {Kind::kB0, Kind::kB1},
                                    {Kind::kA1, Kind::kA0},
                                    {Kind::kB1, Kind::kB0},
                                    {Kind::kC0, Kind::kC1},
                                    {Kind::kD0, Kind::kC1},
                                    {Kind::kC1, Kind::kC0},
                                    {Kind::kD1, Kind::kC1},
                                    {Kind::kAM, Kind::kA1},
                                    {Kind::kCM, Kind::kC1}}) {
    largest = std::max(largest, error(kind, scale));
  }
  return largest;
}

// Up to 2000, the largest loss factor of a mode, over steps from far below to far above the decay
// times of both roots. 1e-13: some hundred roundings.
TEST(StepWeights, AreExactHoweverStrongTheDamping) {
  for (const double eta : {50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0}) {
    for (double theta = 1e-5; theta < 200.0; theta *= 1.7) {
      EXPECT_LT(largest_error(eta, theta), 1e-13) << "eta " << eta << ", theta " << theta;
    }
  }
}

// Across all the ways to compute them. Near critical damping, and where a long step holds many
// periods, the exponent of the decay is rounded: 1e-12.
TEST(StepWeights, AreExactForAnyDamping) {
  for (const double eta :
       {0.0, 0.01, 0.5, 1.0, 1.9, 1.9999, 2.0001, 2.1, 2.3, 2.4, 3.0, 5.0, 20.0}) {
    for (double theta = 1e-4; theta < 200.0; theta *= 1.3) {
      EXPECT_LT(largest_error(eta, theta), 1e-12) << "eta " << eta << ", theta " << theta;
    }
  }
}

// The free vibration, whose velocity falls to 1/η² of what it was: relative to itself.
TEST(StepWeights, KeepTheSlowDecayOfAStronglyDampedMode) {
  constexpr double kLength = 0.01;
  for (const double eta : {50.0, 500.0, 2000.0}) {
    for (double theta = 1e-2; theta < 3.0; theta *= 1.7) {
      const Mode mode{theta / kLength, eta};
      StepWeights weights(std::vector<Mode>{mode});
      weights.set_length(kLength);
      const auto exact = exact_weights(mode.angular_frequency, eta, kLength);
      for (const Kind kind : {Kind::kE11, Kind::kE12, Kind::kE21, Kind::kE22}) {
        const double expected = static_cast<double>(exact[kind]);
        // Where the fast root still counts the slope passes 0.
        if (eta * theta < 40.0) continue;
        EXPECT_NEAR(weights(kind, 0), expected, 1e-13 * std::abs(expected))
            << "eta " << eta << ", theta " << theta << ", kind " << kind;
      }
    }
  }
}

}  // namespace
}  // namespace microslip::march_weights_test
