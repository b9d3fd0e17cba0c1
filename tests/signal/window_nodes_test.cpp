// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "microslip/signal/decay/decay_window.hpp"
#include "microslip/signal/decay/tapered_transform.hpp"
#include "microslip/signal/decay/window_nodes.hpp"
#include "signal/decays.hpp"

/// Nodes of a window against its samples.

namespace microslip::window_nodes_test {
namespace {

using microslip::testing::sampled;
using microslip::testing::ViscousMode;
using microslip::testing::with_noise;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr ViscousMode kMode{.frequency = 70.0, .damping_ratio = 0.004};

/// A window about 1 s of a decay of 2 s with another mode 20 lines away.
struct Window {
  Window(double rate, double length)
      : signal(with_noise(
            sampled({kMode, {.frequency = 70.0 + 20.0 / length, .damping_ratio = 0.0005}}, 0, rate,
                    2.0),
            0.01, 3)),
        tapered(signal, rate, 1.0, length),
        nodes(tapered, kTwoPi * 60.0, kTwoPi * 80.0) {}

  std::vector<double> signal;
  TaperedWindow tapered;
  WindowNodes nodes;
};

TEST(WindowNodes, AreFewHoweverDenseTheSamples) {
  for (const double rate : {12800.0, 102400.0}) {
    EXPECT_LE(Window(rate, 0.9).nodes.size(), 200U);  // 63 periods
    EXPECT_LE(Window(rate, 0.1).nodes.size(), 200U);  // 7 periods, 24 nodes each
  }
  // Of few samples all are nodes.
  const Window sparse(512.0, 0.5);
  EXPECT_EQ(sparse.nodes.size(), sparse.tapered.size());
  EXPECT_FALSE(sparse.nodes.is_complex());
}

// At 12 lines a signal turns by a tenth from node to node, and is off by 10⁻³(2πx)⁸, 4·10⁻⁵: there
// are side lobes of the mode and its neighbour alone, and of the noise 1 % of the amplitude by √n.
TEST(WindowNodes, HaveTheTransformOfTheSamples) {
  for (const double length : {0.9, 0.1}) {
    const Window window(12800.0, length);
    const double peak = std::abs(window.tapered.transform(kTwoPi * kMode.frequency));
    for (const double lines : {-12.0, -6.0, -2.0, 0.0, 1.0, 5.0, 12.0}) {
      const double omega = kTwoPi * (kMode.frequency + lines / length);
      if (omega <= 0.0) continue;
      ASSERT_TRUE(window.nodes.holds(omega));
      const std::complex<double> of_samples = window.tapered.transform(omega);
      const std::complex<double> of_nodes = window.nodes.transform(window.nodes.values(), omega);
      EXPECT_LE(std::abs(of_nodes - of_samples), 1e-5 * peak) << length << ": " << lines;
    }
  }
}

/// A window of the signal and of each so many of its samples, with the noise of one sample.
void expect_same_fit(double length, std::size_t every) {
  constexpr double kDense = 25600.0;  // Hz
  const std::vector<double> dense = sampled({kMode}, 2, kDense, 2.0);
  std::vector<double> sparse;
  for (std::size_t i = 0; i < dense.size(); i += every) sparse.push_back(dense[i]);
  const double rate = kDense / static_cast<double>(every);
  const auto of_nodes = fit_decay_window(dense, kDense, 1.0, length, 60.0, 80.0, {});
  const auto of_samples = fit_decay_window(sparse, rate, 1.0, length, 60.0, 80.0, {});
  ASSERT_TRUE(of_nodes && of_samples);
  EXPECT_NEAR(of_nodes->decay / kMode.decay(), 1.0, 1e-6);
  // 2·10⁻⁷ in δT of the short window, and so in its 44 rad.
  EXPECT_NEAR(of_nodes->omega / kMode.damped_omega(), 1.0, 5e-9);
  EXPECT_NEAR(of_nodes->amplitude / of_samples->amplitude, 1.0, 1e-7);
  // Over the variance of a sample: with so many times the samples so much less.
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(
        static_cast<double>(every) * of_nodes->covariance(i, i) / of_samples->covariance(i, i), 1.0,
        1e-3)
        << i;
  }
}

// Least squares on nodes are those on samples. The model is exact for a viscous mode; δT is 1.6 and
// 0.18, and interpolation between 24 nodes a period is off by 10⁻⁸.
TEST(WindowNodes, GiveTheFitOfTheSamples) {
  expect_same_fit(0.9, 64);  // 360 samples, 5.7 a period: all of them
  expect_same_fit(0.1, 16);  // 160 samples
}

}  // namespace
}  // namespace microslip::window_nodes_test
