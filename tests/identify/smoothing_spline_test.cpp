// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/smoothing_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/lu.hpp"
#include "microslip/algebra/qr.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"

namespace microslip::smoothing_spline_test {
namespace {

using Vector = std::vector<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Data {
  Vector x;
  Vector y;
  Vector w;
};

/// Noisy values of a smooth curve over unequal x, with unequal weights; x in steps of about `step`.
Data random_data(std::uint64_t seed, std::size_t n, double noise, double step = 1.0) {
  RandomStream random(seed, 0);
  Data d;
  double x = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    x += step * (0.2 + 1.6 * random.uniform());
    const double phase = 9.0 * static_cast<double>(i) / static_cast<double>(n);
    d.x.push_back(x);
    d.y.push_back(std::sin(phase) + noise * random.normal());
    d.w.push_back(0.1 + 10.0 * random.uniform());
  }
  return d;
}

double largest(const Vector& v) {
  double most = 0.0;
  for (const double value : v) most = std::max(most, std::abs(value));
  return most;
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using Column = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

Column column(const Vector& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()))
      .cast<long double>();
}

/// The matrix that turns y into g(x), by dense algebra in long double: (I + λW⁻¹QR⁻¹Qᵀ)⁻¹.
Matrix dense_smoother(const Data& d, double lambda) {
  const auto n = static_cast<Eigen::Index>(d.x.size());
  Matrix q = Matrix::Zero(n, n - 2);
  Matrix r = Matrix::Zero(n - 2, n - 2);
  for (Eigen::Index j = 0; j < n - 2; ++j) {
    const auto i = static_cast<std::size_t>(j);
    const long double left = d.x[i + 1] - d.x[i];
    const long double right = d.x[i + 2] - d.x[i + 1];
    q(j, j) = 1.0L / left;
    q(j + 1, j) = -1.0L / left - 1.0L / right;
    q(j + 2, j) = 1.0L / right;
    r(j, j) = (left + right) / 3.0L;
    if (j + 1 < n - 2) r(j, j + 1) = r(j + 1, j) = right / 6.0L;
  }
  const Column w = column(d.w);
  const Matrix penalty = q * r.ldlt().solve(q.transpose());
  const Matrix system = Matrix::Identity(n, n) + lambda * w.cwiseInverse().asDiagonal() * penalty;
  return system.fullPivLu().inverse();
}

/// ∫ g″² of a spline whose g″ is piecewise linear.
double roughness(const NaturalSpline& g) {
  const auto x = g.knots();
  const auto s = g.knot_second_derivatives();
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    sum += (x[i + 1] - x[i]) / 3.0 * (s[i] * s[i] + s[i] * s[i + 1] + s[i + 1] * s[i + 1]);
  }
  return sum;
}

// Rounding times the condition number of the equations: against 50 digits both programs are within
// 1e-12, but for case 14 (200 points, p = 1e-8), where csaps is off by 9e-10 and we are by 3e-10.
TEST(SmoothingSpline, EqualsCsaps) {
  const auto table = testing::reference_table("csaps.csv");
  const Vector& number = table["case [1]"];
  for (std::size_t begin = 0; begin < number.size();) {
    const auto end = static_cast<std::size_t>(
        std::find_if(number.begin(), number.end(), [&](double c) { return c > number[begin]; }) -
        number.begin());
    SCOPED_TRACE("case " + std::to_string(number[begin]));
    const auto part = [&](const std::string& name) {
      return std::span(table[name]).subspan(begin, end - begin);
    };
    const auto x = part("x [1]");
    const double p = part("p [1]").front();
    const auto result = fit_smoothing_spline(x, part("y [1]"), part("weight [1]"), MatlabP{p, 1.0});
    EXPECT_TRUE(result.summary.converged());
    EXPECT_NEAR(result.edf, part("edf [1]").front(), 1e-8 * static_cast<double>(x.size()));
    const double scale = largest(Vector(part("between [1]").begin(), part("between [1]").end()));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double gap = i + 1 < x.size() ? x[i + 1] - x[i] : x[i] - x[i - 1];
      EXPECT_NEAR(result.spline.value(x[i]), part("value [1]")[i], 1e-9 * scale);
      test::record_largest("difference [1]",
                           std::abs(result.spline.value(x[i]) - part("value [1]")[i]) / scale);
      EXPECT_NEAR(result.spline.value(x[i] + 0.37 * gap), part("between [1]")[i], 1e-9 * scale);
    }
    begin = end;
  }
}

// SciPy stops its search at 1e-5 absolute, about 1e-4 of the smallest λ; near the minimum the curve
// depends on λ by less than that, and our GCV may not be above theirs.
TEST(SmoothingSpline, GcvChoosesWhatScipyChooses) {
  const auto table = testing::reference_table("scipy_smoothing_spline.csv");
  for (const double number : {1.0, 2.0, 3.0}) {
    SCOPED_TRACE(number);
    Data d;
    Vector value;
    double lambda = 0.0;
    for (std::size_t i = 0; i < table.rows(); ++i) {
      if (table["case [1]"][i] != number) continue;
      d.x.push_back(table["x [1]"][i]);
      d.y.push_back(table["y [1]"][i]);
      value.push_back(table["value [1]"][i]);
      lambda = table["lambda [1]"][i];
    }
    const auto ours = fit_smoothing_spline(d.x, d.y, {});
    const auto theirs = fit_smoothing_spline(d.x, d.y, {}, FixedLambda{lambda});
    EXPECT_NEAR(ours.lambda / lambda, 1.0, 2e-4);
    EXPECT_LE(ours.gcv, theirs.gcv * (1.0 + 1e-12));
    EXPECT_LT(largest_difference(ours.spline.knot_values(), value), 1e-4);
    EXPECT_LT(largest_difference(theirs.spline.knot_values(), value), 1e-11);
    EXPECT_TRUE(ours.summary.converged());
    EXPECT_LT(ours.summary.residual, 1e-5);
  }
}

TEST(SmoothingSpline, FreedomIsTheTraceOfTheDenseSmoother) {
  for (const std::size_t n : {3U, 4U, 5U, 20U, 120U}) {
    for (const double lambda : {1e-6, 1e-2, 1.0, 1e3, 1e7}) {
      SCOPED_TRACE(::testing::Message() << n << " points, lambda " << lambda);
      const Data d = random_data(11, n, 0.1);
      const Matrix a = dense_smoother(d, lambda);
      const auto trace = static_cast<double>(a.trace());
      const auto result = fit_smoothing_spline(d.x, d.y, d.w, FixedLambda{lambda});
      // The leverages lose the condition number of the equations, 16λ here; edf itself far less.
      const double rounding = 1e-11 + 16.0 * lambda * std::numeric_limits<double>::epsilon();
      EXPECT_NEAR(result.edf, trace, 1e-10 * trace);
      EXPECT_NEAR(std::accumulate(result.leverage.begin(), result.leverage.end(), 0.0), trace,
                  rounding * trace);
      for (std::size_t i = 0; i < n; ++i) {
        const auto j = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(result.leverage[i], static_cast<double>(a(j, j)), rounding);
      }
      const Column residual = column(d.y) - a * column(d.y);
      const auto rss = static_cast<double>(residual.dot(column(d.w).asDiagonal() * residual));
      const double freedom = static_cast<double>(static_cast<long double>(n) - a.trace());
      EXPECT_NEAR(result.gcv * freedom * freedom / (static_cast<double>(n) * rss), 1.0, 1e-9);
      EXPECT_NEAR(result.sigma_hat * result.sigma_hat * freedom / rss, 1.0, 1e-9);
    }
  }
}

// The minimiser: any other natural spline of the same knots has a larger objective.
TEST(SmoothingSpline, NoNeighbourIsBetter) {
  const Data d = random_data(5, 30, 0.2);
  const double lambda = 2.0;
  const auto best = fit_smoothing_spline(d.x, d.y, d.w, FixedLambda{lambda}).spline;
  const auto objective = [&](const NaturalSpline& g) {
    double sum = lambda * roughness(g);
    for (std::size_t i = 0; i < d.x.size(); ++i) {
      sum += d.w[i] * std::pow(d.y[i] - g.value(d.x[i]), 2);
    }
    return sum;
  };
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomStream random(seed, 1);
    Vector other(best.knot_values().begin(), best.knot_values().end());
    for (double& value : other) value += 1e-3 * random.normal();
    const auto moved = fit_smoothing_spline(d.x, other, {}, FixedLambda{0.0}).spline;
    EXPECT_GT(objective(moved), objective(best)) << "seed " << seed;
  }
}

TEST(SmoothingSpline, NoUnitAndNoOrderChangesTheCurve) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Data d = random_data(seed, 25, 0.1);
    const auto micrometres = fit_smoothing_spline(d.x, d.y, d.w);
    Data si = d;
    for (double& x : si.x) x *= 1e-6;
    for (double& y : si.y) y *= 1e-3;
    std::ranges::reverse(si.x);
    std::ranges::reverse(si.y);
    std::ranges::reverse(si.w);
    const auto metres = fit_smoothing_spline(si.x, si.y, si.w);
    // A search for a minimum finds λ to the square root of the rounding.
    EXPECT_NEAR(metres.scaled_lambda / micrometres.scaled_lambda, 1.0, 1e-5) << seed;
    EXPECT_NEAR(metres.lambda / (micrometres.lambda * 1e-18), 1.0, 1e-5) << seed;
    const double p = 1.0 / (1.0 + micrometres.lambda);
    const auto again = fit_smoothing_spline(si.x, si.y, si.w, MatlabP{p, 1e-6});
    // 1 − p has lost the digits that p has not
    EXPECT_NEAR(again.edf / micrometres.edf, 1.0, 1e-9) << seed;
    for (std::size_t i = 0; i < d.x.size(); ++i) {
      EXPECT_NEAR(again.spline.value(d.x[i] * 1e-6), 1e-3 * micrometres.spline.value(d.x[i]),
                  1e-11);
    }
  }
}

TEST(SmoothingSpline, RepeatedXCountAsWhatTheyAre) {
  const Data d = random_data(3, 12, 0.1);
  Data repeated = d;
  repeated.x.insert(repeated.x.end(), {d.x[4], d.x[7], d.x[4]});
  repeated.y.insert(repeated.y.end(), {0.3, -0.2, 0.9});
  repeated.w.insert(repeated.w.end(), {2.0, 0.5, 1.0});
  const auto result = fit_smoothing_spline(repeated.x, repeated.y, repeated.w, FixedLambda{0.7});

  Data merged = d;
  merged.w[4] = d.w[4] + 3.0;
  merged.y[4] = (d.w[4] * d.y[4] + 2.0 * 0.3 + 0.9) / merged.w[4];
  merged.w[7] = d.w[7] + 0.5;
  merged.y[7] = (d.w[7] * d.y[7] - 0.5 * 0.2) / merged.w[7];
  const auto expected = fit_smoothing_spline(merged.x, merged.y, merged.w, FixedLambda{0.7});
  EXPECT_LT(largest_difference(result.spline.knot_values(), expected.spline.knot_values()), 1e-14);
  EXPECT_NEAR(result.edf, expected.edf, 1e-13);

  double rss = 0.0;
  for (std::size_t i = 0; i < repeated.x.size(); ++i) {
    rss += repeated.w[i] * std::pow(repeated.y[i] - result.spline.value(repeated.x[i]), 2);
  }
  EXPECT_NEAR(result.sigma_hat, std::sqrt(rss / (15.0 - result.edf)), 1e-12 * result.sigma_hat);
  EXPECT_NEAR(result.gcv, 15.0 * rss / std::pow(15.0 - result.edf, 2), 1e-12 * result.gcv);
}

TEST(SmoothingSpline, EndsOfTheRange) {
  const Data d = random_data(8, 15, 0.3);
  const auto through = fit_smoothing_spline(d.x, d.y, d.w, MatlabP{1.0, 1e-6});
  EXPECT_DOUBLE_EQ(through.edf, 15.0);
  EXPECT_EQ(largest_difference(through.spline.knot_values(), d.y), 0.0);
  EXPECT_TRUE(std::isnan(through.sigma_hat));
  EXPECT_TRUE(std::isnan(through.gcv));

  const auto line = fit_smoothing_spline(d.x, d.y, d.w, MatlabP{0.0, 1e-6});
  EXPECT_EQ(line.edf, 2.0);
  EXPECT_EQ(line.lambda, kInfinity);
  EXPECT_NEAR(std::accumulate(line.leverage.begin(), line.leverage.end(), 0.0), 2.0, 1e-14);
  EXPECT_EQ(roughness(line.spline), 0.0);
  double moment0 = 0.0;
  double moment1 = 0.0;  // residuals of a weighted line are orthogonal to 1 and x
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    const double residual = d.w[i] * (d.y[i] - line.spline.value(d.x[i]));
    moment0 += residual;
    moment1 += residual * d.x[i];
  }
  EXPECT_NEAR(moment0, 0.0, 1e-12);
  EXPECT_NEAR(moment1, 0.0, 1e-11);

  // and near them: 1e10 is far above the λ that bends 15 points, 1e-10 far below
  const auto nearly = fit_smoothing_spline(d.x, d.y, d.w, FixedLambda{1e10});
  EXPECT_LT(largest_difference(nearly.spline.knot_values(), line.spline.knot_values()), 1e-5);
  EXPECT_NEAR(nearly.edf, 2.0, 1e-5);
  const auto rough = fit_smoothing_spline(d.x, d.y, d.w, FixedLambda{1e-10});
  EXPECT_LT(largest_difference(rough.spline.knot_values(), d.y), 1e-8);
}

TEST(SmoothingSpline, TwoPointsAreALine) {
  const auto result = fit_smoothing_spline(Vector{1.0, 3.0}, Vector{5.0, 9.0}, {}, FixedLambda{1});
  EXPECT_DOUBLE_EQ(result.spline.value(2.0), 7.0);
  EXPECT_DOUBLE_EQ(result.spline.value(0.0), 3.0);
  EXPECT_DOUBLE_EQ(result.edf, 2.0);
}

TEST(SmoothingSpline, MeetsTheTargetFreedom) {
  const Data d = random_data(21, 60, 0.2, 1e-6);
  for (const double edf : {2.01, 3.0, 10.0, 45.0, 59.9}) {
    const auto result = fit_smoothing_spline(d.x, d.y, d.w, TargetEdf{edf});
    EXPECT_NEAR(result.edf, edf, 1e-9 * edf);
    EXPECT_TRUE(result.summary.converged());
  }
  EXPECT_EQ(fit_smoothing_spline(d.x, d.y, d.w, TargetEdf{2.0}).lambda, kInfinity);
  EXPECT_EQ(fit_smoothing_spline(d.x, d.y, d.w, TargetEdf{60.0}).lambda, 0.0);
}

// The freedom falls and the residual rises with λ.
TEST(SmoothingSpline, CurveOfTheChoice) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Data d = random_data(seed, 50, 0.2, 1e-5);
    const auto result = fit_smoothing_spline(d.x, d.y, d.w);
    ASSERT_GT(result.gcv_curve.size(), 20U);
    EXPECT_TRUE(std::ranges::is_sorted(result.gcv_curve, {}, &GcvPoint::lambda));
    EXPECT_TRUE(std::ranges::is_sorted(result.gcv_curve, std::greater{}, &GcvPoint::edf));
    EXPECT_NEAR(result.gcv_curve.front().edf, 50.0, 0.1);
    EXPECT_LT(result.gcv_curve.back().edf, 2.01);
    for (const GcvPoint& point : result.gcv_curve) EXPECT_LE(result.gcv, point.gcv);
  }
}

// γ > 1 never smooths less, and keeps short noisy records from being interpolated.
TEST(SmoothingSpline, FreedomCanBeChargedMore) {
  int plain_rough = 0;
  int guarded_rough = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, 3);
    Data d;
    for (int i = 0; i < 12; ++i) {
      d.x.push_back(i);
      d.y.push_back(0.05 * i * i + random.normal());
    }
    const double plain = fit_smoothing_spline(d.x, d.y, {}).edf;
    const double guarded = fit_smoothing_spline(d.x, d.y, {}, Gcv{.edf_factor = 1.4}).edf;
    EXPECT_LE(guarded, plain * (1.0 + 1e-6)) << seed;
    plain_rough += plain > 8.0 ? 1 : 0;
    guarded_rough += guarded > 8.0 ? 1 : 0;
  }
  EXPECT_GT(plain_rough, 10);
  EXPECT_LT(guarded_rough, plain_rough / 3);
}

// With noise of a known deviation and weights 1/σ², σ̂ is 1: its scatter is 1/√(2·(200 − edf)) =
// 0.05 for one draw, 0.011 for the mean of 20, and four times that is allowed. The bands of Wahba
// cover the truth 95 % of the time on average over the knots; the mean over 4000 correlated knots
// is within a few percent.
TEST(SmoothingSpline, NoiseAndBandsAreRight) {
  double sigma = 0.0;
  double covered = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, 2);
    Data d;
    for (int i = 0; i < 200; ++i) {
      const double deviation = 0.05 + 0.2 * random.uniform();
      d.x.push_back(i);
      d.y.push_back(std::sin(0.05 * i) + deviation * random.normal());
      d.w.push_back(1.0 / (deviation * deviation));
    }
    const auto result = fit_smoothing_spline(d.x, d.y, d.w);
    sigma += result.sigma_hat / 20.0;
    for (std::size_t i = 0; i < 200; ++i) {
      const double miss = result.spline.knot_values()[i] - std::sin(0.05 * d.x[i]);
      covered += std::abs(miss) <= 1.96 * result.standard_error[i] ? 1.0 / 4000.0 : 0.0;
    }
  }
  EXPECT_NEAR(sigma, 1.0, 0.045);
  EXPECT_NEAR(covered, 0.95, 0.04);
}

TEST(SmoothingSpline, DerivativesAreThoseOfTheCurve) {
  const Data d = random_data(9, 20, 0.1);
  const auto g = fit_smoothing_spline(d.x, d.y, d.w, FixedLambda{0.5}).spline;
  RandomStream random(1, 0);
  const double step = 1e-4;
  for (int i = 0; i < 200; ++i) {
    const double x = d.x.front() - 2.0 + (d.x.back() - d.x.front() + 4.0) * random.uniform();
    // On a cubic the central difference of the value is off by step²g‴/6, of the slope by rounding.
    EXPECT_NEAR((g.value(x + step) - g.value(x - step)) / (2.0 * step), g.first_derivative(x),
                1e-7);
    EXPECT_NEAR((g.first_derivative(x + step) - g.first_derivative(x - step)) / (2.0 * step),
                g.second_derivative(x), 2e-4);
  }
  const double end = d.x.back();
  EXPECT_NEAR(g.value(end), g.value(std::nextafter(end, kInfinity)), 1e-12);
  EXPECT_NEAR(g.first_derivative(end), g.first_derivative(std::nextafter(end, 0.0)), 1e-12);
  EXPECT_EQ(g.second_derivative(end + 1.0), 0.0);
}

// 1e5 points with one λ: the freedom for equal spacing and weights is 2 + Σ 1/(1 + λ(ν_k/n)⁴) with
// the free-free beam's ν_k ≈ (k + ½)π, k = 1, 2, …, up to the discreteness, some 1e-3 at λ = 1e4.
TEST(SmoothingSpline, ManyPoints) {
  const std::size_t n = 100000;
  Data d;
  RandomStream random(4, 0);
  for (std::size_t i = 0; i < n; ++i) {
    d.x.push_back(static_cast<double>(i));
    d.y.push_back(std::sin(1e-3 * d.x.back()) + 0.1 * random.normal());
  }
  for (const double lambda : {1e4, 1e8, 1e12}) {
    double expected = 2.0;
    for (std::size_t k = 1; k < n; ++k) {
      const double nu = (static_cast<double>(k) + 0.5) * M_PI / static_cast<double>(n);
      expected += 1.0 / (1.0 + lambda * nu * nu * nu * nu);
    }
    const auto result = fit_smoothing_spline(d.x, d.y, {}, FixedLambda{lambda});
    EXPECT_NEAR(result.edf / expected, 1.0, 3e-3) << lambda;
    EXPECT_TRUE(result.warnings.empty()) << lambda;
  }
  const auto best = fit_smoothing_spline(d.x, d.y, {});
  EXPECT_NEAR(best.sigma_hat, 0.1, 0.001);  // four times 0.1/√(2·1e5)
  EXPECT_LT(best.summary.wall_seconds, 20.0) << "O(n): a fraction of a second on an idle machine";
}

TEST(SmoothingSpline, SaysWhatIsSpecial) {
  const Data d = random_data(2, 20, 0.1);
  const auto flagged = fit_smoothing_spline(d.x, d.y, {}, FixedLambda{1e14});
  ASSERT_EQ(flagged.warnings.size(), 1U);
  EXPECT_EQ(flagged.warnings[0].code, "smoothing_too_large");
  EXPECT_TRUE(flagged.summary.converged());
  const Data many = random_data(2, 1500, 0.1);
  EXPECT_FALSE(fit_smoothing_spline(many.x, many.y, {}, FixedLambda{1e14}).summary.converged());
  EXPECT_TRUE(fit_smoothing_spline(many.x, many.y, {}, FixedLambda{kInfinity}).summary.converged());

  Vector clean;
  for (const double x : d.x) clean.push_back(std::exp(0.1 * x));
  const auto rough = fit_smoothing_spline(d.x, clean, {});
  ASSERT_EQ(rough.warnings.size(), 1U);
  EXPECT_EQ(rough.warnings[0].code, "gcv_at_end_of_range");
}

std::string error_of(const Vector& x, const Vector& y, const Vector& w,
                     const Smoothing& smoothing) {
  try {
    (void)fit_smoothing_spline(x, y, w, smoothing);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SmoothingSpline, RefusesWhatIsNotInRange) {
  const Vector x{1, 2, 3, 4};
  const Vector y{1, 2, 3, 4};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(x, y, {}, MatlabP{1.5, 1.0}),
            "smoothing factor p = 1.5; must lie in [0, 1]. 0 is the straight line, 1 interpolates");
  EXPECT_NE(error_of(x, y, {}, MatlabP{nan, 1.0}).find("smoothing factor p = nan"),
            std::string::npos);
  EXPECT_NE(error_of(x, y, {}, MatlabP{0.5, 0.0}).find("x_unit_in_metres = 0"), std::string::npos);
  EXPECT_EQ(error_of(x, y, {}, FixedLambda{-1.0}), "lambda = -1; must be 0 or more");
  EXPECT_NE(error_of(x, y, {}, TargetEdf{4.5}).find("target edf = 4.5; must lie in [2, 4]"),
            std::string::npos);
  EXPECT_EQ(error_of(x, {1, 2, 3}, {}, Gcv{}), "length of y = 3; must be that of x, 4");
  EXPECT_EQ(error_of(x, {1, 2, nan, 4}, {}, Gcv{}), "y number 3 = nan; must be finite");
  EXPECT_NE(error_of(x, y, {1, 0, 1, 1}, Gcv{}).find("weight number 2 = 0; must be positive"),
            std::string::npos);
  EXPECT_NE(error_of({1, 1, 1}, {1, 2, 3}, {}, FixedLambda{1.0}).find("number of distinct x = 1"),
            std::string::npos);
  EXPECT_NE(error_of({1, 1, 2, 3}, {1, 2, 3, 4}, {}, Gcv{}).find("number of distinct x = 3"),
            std::string::npos);
  EXPECT_NE(error_of({}, {}, {}, Gcv{}).find("number of distinct x = 0"), std::string::npos);
  EXPECT_NE(error_of(x, y, {}, Gcv{.edf_factor = 0.5}).find("edf_factor = 0.5"), std::string::npos);
  EXPECT_NE(error_of(x, y, {}, Gcv{.grid_per_decade = 0}).find("grid_per_decade"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::smoothing_spline_test
