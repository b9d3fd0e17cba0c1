// SPDX-License-Identifier: MIT
#include "microslip/observe/neighbour_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"

namespace microslip::neighbour_scatter_test {
namespace {

struct Points {
  std::vector<double> x;
  std::vector<double> y;
};

/// Unequally spaced points on a parabola of the given curvature, with noise.
Points points(std::size_t count, double curvature, double noise, std::uint64_t seed) {
  RandomStream random(seed, 0);
  Points p;
  double x = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    x += 0.2 + 1.6 * random.uniform();
    p.x.push_back(x);
    p.y.push_back(3.0 - 2.0 * x + 0.5 * curvature * x * x + noise * random.normal());
  }
  return p;
}

TEST(Scatter, NoneOnAStraightLine) {
  const Points p = points(50, 0.0, 0.0, 1);
  EXPECT_LT(scatter_about_neighbours(p.x, p.y), 1e-13);  // rounding of values up to 100
}

// The deviations are those of normal variables of the right variance at any spacing. The median of
// 4000, of which neighbours are correlated, has a standard deviation of some 2 %: 6 % is three of
// them.
TEST(Scatter, IsThatOfTheNoise) {
  for (const double noise : {1e-6, 1.0, 1e6}) {
    const Points p = points(4000, 0.0, noise, 2);
    EXPECT_NEAR(scatter_about_neighbours(p.x, p.y) / noise, 1.0, 0.06);
  }
}

// With as few points as a test has it is right in the mean: 90 points, 200 draws, a deviation of 14
// % each; three standard errors of the mean are 3 %, and as much is left for the median of few
// values.
TEST(Scatter, HasLittleBiasOnFewPoints) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Points p = points(90, 0.0, 1.0, 100 + seed);
    sum += scatter_about_neighbours(p.x, p.y) / 200.0;
  }
  EXPECT_NEAR(sum, 1.0, 0.06);
}

// Curvature that moves the middle of two neighbours by a tenth of the noise counts as almost none,
// and a few outliers move a median little: ten of 400 by 3 % or so.
TEST(Scatter, WithstandsCurvatureAndOutliers) {
  Points p = points(400, 0.2, 1.0, 3);
  EXPECT_NEAR(scatter_about_neighbours(p.x, p.y), 1.0, 0.15);
  for (std::size_t i = 20; i < 400; i += 40) p.y[i] += 1000.0;
  EXPECT_NEAR(scatter_about_neighbours(p.x, p.y), 1.0, 0.25);
}

TEST(Scatter, NeedsThreePoints) {
  const std::vector<double> two{1.0, 2.0};
  const std::vector<double> three{1.0, 2.0, 3.0};
  EXPECT_THROW((void)scatter_about_neighbours(two, two), InputError);
  EXPECT_THROW((void)scatter_about_neighbours(three, two), InputError);
  // One deviation: |½·1 + ½·3 − 5|/√1.5 over the median of |z|.
  const std::vector<double> y{1.0, 5.0, 3.0};
  EXPECT_NEAR(scatter_about_neighbours(three, y), 3.0 / std::sqrt(1.5) / 0.6744897501960817, 1e-14);
}

// What bends is no scatter: a curve of third order leaves none, where straight lines through
// neighbours see its curvature. Of eight points there are no cubics.
TEST(Scatter, NoneAboutACubic) {
  Points p = points(30, 0.0, 0.0, 3);
  for (std::size_t i = 0; i < p.x.size(); ++i) p.y[i] = std::pow(0.1 * p.x[i] - 1.0, 3);
  const std::vector<double> unit(p.x.size(), 1.0);
  EXPECT_LT(scatter_about_curve(p.x, p.y, unit), 1e-10);
  EXPECT_GT(scatter_about_neighbours(p.x, p.y), 1e-3);
  const std::span<const double> x(p.x);
  const std::span<const double> y(p.y);
  EXPECT_EQ(scatter_about_curve(x.first(8), y.first(8), std::span(unit).first(8)),
            scatter_about_neighbours(x.first(8), y.first(8)));
}

// In units of the deviations of the points, which may differ. 6 % as above.
TEST(Scatter, AboutACurveIsInDeviations) {
  Points p = points(4000, 1e-3, 0.0, 4);
  RandomStream random(5, 0);
  std::vector<double> sigma;
  for (double& y : p.y) {
    sigma.push_back(random.uniform() < 0.5 ? 0.1 : 3.0);
    y += 2.0 * sigma.back() * random.normal();
  }
  EXPECT_NEAR(scatter_about_curve(p.x, p.y, sigma), 2.0, 0.06 * 2.0);
  sigma.pop_back();
  EXPECT_THROW((void)scatter_about_curve(p.x, p.y, sigma), InputError);
}

}  // namespace
}  // namespace microslip::neighbour_scatter_test
