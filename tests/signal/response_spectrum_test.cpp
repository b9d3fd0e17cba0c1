// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/messages.hpp"

namespace microslip::response_spectrum_test {
namespace {

using std::numbers::pi;

struct Pulse {
  std::vector<double> time;
  std::vector<double> acceleration;
};

Pulse half_sine(double peak, double duration, int pieces) {
  Pulse pulse;
  for (int i = 0; i <= pieces; ++i) {
    pulse.time.push_back(duration * i / pieces);
    pulse.acceleration.push_back(peak * std::sin(pi * i / pieces));
  }
  return pulse;
}

/// max |ẍ| of an undamped mass under a half-sine, in closed form: during the pulse
/// A/(1 − β²)[sin Ωt − β sin ωt], β = Ω/ω, looked through finely; after it 2Aβ cos(π/(2β))/(1 −
/// β²). [Chopra, Dynamics of Structures, 4.8]
double exact_maximax(double peak, double duration, double frequency) {
  const double omega = 2.0 * pi * frequency;
  const double beta = pi / duration / omega;
  double most = std::abs(2.0 * peak * beta * std::cos(pi / (2.0 * beta)) / (1.0 - beta * beta));
  for (int i = 0; i <= 200'000; ++i) {
    const double t = duration * i / 200'000;
    most = std::max(most, std::abs(peak / (1.0 - beta * beta) *
                                   (std::sin(pi * t / duration) - beta * std::sin(omega * t))));
  }
  return most;
}

// The chords of 2000 pieces lie 3e-7 beside the sine; a parabola through three of 40 points a
// period leaves 1e-5 of the height.
TEST(ResponseSpectrum, OfAHalfSineIsThatInClosedForm) {
  const Pulse pulse = half_sine(50.0, 0.011, 2000);
  const std::vector<double> frequency{3.0, 11.0, 30.0, 70.0, 150.0, 400.0, 1500.0};
  const ResponseSpectrum found = response_spectrum(pulse.time, pulse.acceleration, frequency, 0.0);
  const std::vector<double> maximax = found.maximax();
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const double exact = exact_maximax(50.0, 0.011, frequency[i]);
    EXPECT_NEAR(maximax[i] / exact, 1.0, 2e-5) << frequency[i];
    // Without damping ẍ = −ω²z.
    const double omega = 2.0 * pi * frequency[i];
    EXPECT_NEAR(found.displacement[i] * omega * omega, maximax[i], 1e-9 * maximax[i]);
  }
}

// A step of a constant acceleration: z overshoots −a/ω² by e^{−πζ/√(1−ζ²)}. [Chopra 4.3]
TEST(ResponseSpectrum, OfAStepOvershootsByTheDamping) {
  for (const double damping : {0.0, 0.05, 0.3, 0.7}) {
    const std::vector<double> time{0.0, 3.0};
    const std::vector<double> step{2.0, 2.0};
    const ResponseSpectrum found = response_spectrum(time, step, std::vector<double>{1.0}, damping);
    const double over = std::exp(-pi * damping / std::sqrt(1.0 - damping * damping));
    EXPECT_NEAR(found.displacement[0] * 4.0 * pi * pi / 2.0, 1.0 + over, 3e-5) << damping;
  }
}

// A mass that is stiffer than all that happens follows the base; a soft one stands still.
TEST(ResponseSpectrum, GoesToTheBaseAndToRest) {
  const Pulse pulse = half_sine(9.0, 0.1, 500);
  const ResponseSpectrum found =
      response_spectrum(pulse.time, pulse.acceleration, std::vector<double>{0.01, 2000.0}, 0.05);
  EXPECT_NEAR(found.positive[1], 9.0, 2e-3 * 9.0);
  EXPECT_LT(found.maximax()[0], 0.05);
  // The displacement of a soft one is that of the base at the end of a period: its velocity 2Aτ/π
  // times the time, as far as the spring lets it: v/ω.
  EXPECT_NEAR(found.displacement[0], 2.0 * 9.0 * 0.1 / pi / (2.0 * pi * 0.01),
              0.1 * found.displacement[0]);
}

TEST(ResponseSpectrum, NamesWhatIsWrong) {
  const std::vector<double> one{1.0};
  const auto message = [&](std::vector<double> time, std::vector<double> a, std::vector<double> f,
                           double damping) {
    return test::message_or("", [&] { return response_spectrum(time, a, f, damping); });
  };
  EXPECT_EQ(message({0.0, 1.0}, {0.0, 1.0}, one, 0.05), "");
  test::expect_message(message({0.0}, {0.0}, one, 0.05), "times of a response spectrum");
  test::expect_message(message({0.0, 0.0}, {0.0, 1.0}, one, 0.05), "time[1]");
  test::expect_message(message({0.0, 1.0}, {0.0, std::nan("")}, one, 0.05), "acceleration[1]");
  test::expect_message(message({0.0, 1.0}, {0.0, 1.0}, {0.0}, 0.05), "natural frequency");
  test::expect_message(message({0.0, 1.0}, {0.0, 1.0}, one, 1.0), "damping ratio");
}

}  // namespace
}  // namespace microslip::response_spectrum_test
