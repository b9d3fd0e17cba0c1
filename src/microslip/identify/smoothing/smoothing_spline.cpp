// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/smoothing_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/identify/smoothing/infinity.hpp"

namespace microslip {
namespace {

using Vector = std::vector<double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void check_values(std::string_view name, std::span<const double> values, std::size_t size,
                  bool positive) {
  if (values.size() != size) {
    throw InputError(fmt::format("length of {}", name), static_cast<double>(values.size()),
                     fmt::format("must be that of x, {}", size));
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (std::isfinite(values[i]) && (!positive || values[i] > 0.0)) continue;
    throw InputError(fmt::format("{} number {}", name, i + 1), values[i],
                     positive ? "must be positive and finite" : "must be finite",
                     positive ? "Leave out points that shall not count" : "");
  }
}

/// The observations scaled for the solver: one per distinct x, the mean spacing and the mean weight
/// 1.
struct Observations {
  Vector x;                  ///< as given, increasing
  Vector t;                  ///< (x − x_0)/h
  Vector y;                  ///< weighted means
  Vector w;                  ///< sums of weights, divided by their mean
  double spacing = 1.0;      ///< h
  double mean_weight = 1.0;  ///< w̄
  std::size_t count = 0;     ///< before merging
  double repeat_rss = 0.0;   ///< Σ w (y − mean of its x)², in units of w̄

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Degrees of freedom that repeated x add to the residual.
  [[nodiscard]] double repeats() const { return static_cast<double>(count - size()); }
  [[nodiscard]] double lambda_unit() const { return spacing * spacing * spacing * mean_weight; }
};

void merge_equal(std::span<const double> x, std::span<const double> y,
                 std::span<const double> weight, Observations& out) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return x[i]; });
  for (std::size_t begin = 0; begin < order.size();) {
    double sum_w = 0.0;
    double mean = 0.0;
    std::size_t end = begin;
    for (; end < order.size() && x[order[end]] == x[order[begin]]; ++end) {
      const double w = weight.empty() ? 1.0 : weight[order[end]];
      const double step = y[order[end]] - mean;  // the updates of D. H. D. West (1979)
      sum_w += w;
      mean += step * (w / sum_w);
      out.repeat_rss += w * step * (y[order[end]] - mean);
    }
    out.x.push_back(x[order[begin]]);
    out.y.push_back(mean);
    out.w.push_back(sum_w);
    begin = end;
  }
}

Observations prepare(std::span<const double> x, std::span<const double> y,
                     std::span<const double> weight) {
  check_values("x", x, x.size(), false);
  check_values("y", y, x.size(), false);
  if (!weight.empty()) check_values("weight", weight, x.size(), true);
  Observations out;
  out.count = x.size();
  merge_equal(x, y, weight, out);
  const auto n = static_cast<double>(out.size());
  if (out.size() < 2) {
    throw InputError("number of distinct x", n, "must be at least 2", "Measure more levels");
  }
  out.spacing = (out.x.back() - out.x.front()) / (n - 1.0);
  out.mean_weight = std::accumulate(out.w.begin(), out.w.end(), 0.0) / n;
  out.repeat_rss /= out.mean_weight;
  for (double& w : out.w) w /= out.mean_weight;
  for (const double value : out.x) out.t.push_back((value - out.x.front()) / out.spacing);
  const auto equal = std::ranges::adjacent_find(out.t);  // distinct x, equal after the division
  if (!std::isfinite(out.spacing) || equal != out.t.end()) {
    throw InputError("spacing of x", out.spacing, "must be finite, and no gap lost to rounding",
                     "Shift or rescale x");
  }
  return out;
}

/// The minimiser for one λ, in scaled variables.
struct SplineFit {
  double lambda = 0.0;  ///< scaled
  Vector value{};       ///< g at the knots
  Vector second{};      ///< g″ at the knots, both ends included
  Vector leverage{};
  double edf = 0.0;
  double rss = 0.0;           ///< Σ w (y − g)² over all observations
  double residual_dof = 0.0;  ///< observations − edf, without the cancellation

  /// n·RSS/(n − γ·edf)².
  [[nodiscard]] double gcv(std::size_t observations, double edf_factor) const {
    const double left = residual_dof - (edf_factor - 1.0) * edf;
    return left > 0.0 ? static_cast<double>(observations) * rss / (left * left) : kInfinity;
  }
};

/// The three upper bands of a symmetric pentadiagonal matrix.
struct Bands {
  Vector diagonal;
  Vector first;   ///< (j, j + 1)
  Vector second;  ///< (j, j + 2)

  explicit Bands(std::size_t m) : diagonal(m), first(m), second(m) {}
  [[nodiscard]] std::size_t size() const { return diagonal.size(); }
};

/// LDLᵀ of a positive definite one, in place: D on the diagonal, L below (stored above).
void factorise(Bands& b) {
  for (std::size_t j = 0; j < b.size(); ++j) {
    if (j >= 1) b.diagonal[j] -= b.first[j - 1] * b.first[j - 1] * b.diagonal[j - 1];
    if (j >= 2) b.diagonal[j] -= b.second[j - 2] * b.second[j - 2] * b.diagonal[j - 2];
    if (j >= 1) b.first[j] -= b.first[j - 1] * b.second[j - 1] * b.diagonal[j - 1];
    b.first[j] /= b.diagonal[j];
    b.second[j] /= b.diagonal[j];
  }
}

Vector solve(const Bands& ldl, Vector v) {
  const std::size_t m = ldl.size();
  for (std::size_t j = 0; j < m; ++j) {
    if (j >= 1) v[j] -= ldl.first[j - 1] * v[j - 1];
    if (j >= 2) v[j] -= ldl.second[j - 2] * v[j - 2];
  }
  for (std::size_t j = m; j-- > 0;) {
    v[j] /= ldl.diagonal[j];
    if (j + 1 < m) v[j] -= ldl.first[j] * v[j + 1];
    if (j + 2 < m) v[j] -= ldl.second[j] * v[j + 2];
  }
  return v;
}

/// The central bands of the inverse, from the last row up [Hutchinson & de Hoog (1985), section 3].
Bands inverse_bands(const Bands& ldl) {
  const std::size_t m = ldl.size();
  Bands s(m);
  for (std::size_t j = m; j-- > 0;) {
    const double l1 = ldl.first[j];
    const double l2 = ldl.second[j];
    const double s11 = j + 1 < m ? s.diagonal[j + 1] : 0.0;
    const double s12 = j + 2 < m ? s.first[j + 1] : 0.0;
    const double s22 = j + 2 < m ? s.diagonal[j + 2] : 0.0;
    s.first[j] = -l1 * s11 - l2 * s12;
    s.second[j] = -l1 * s12 - l2 * s22;
    s.diagonal[j] = 1.0 / ldl.diagonal[j] - l1 * s.first[j] - l2 * s.second[j];
  }
  return s;
}

/// Reinsch's equations: (R + λQᵀW⁻¹Q)γ = Qᵀy, g = y − λW⁻¹Qγ, with γ = g″ at the inner knots, Q the
/// second divided differences and R the Gram matrix of the hat functions.
class Reinsch {
 public:
  explicit Reinsch(const Observations& data)
      : data_(&data), inner_(data.size() - 2), gram_(inner_), rough_(inner_), qty_(inner_) {
    const Vector& t = data.t;
    for (std::size_t i = 0; i + 1 < t.size(); ++i) inverse_gap_.push_back(1.0 / (t[i + 1] - t[i]));
    for (std::size_t j = 0; j < inner_; ++j) {
      gram_.diagonal[j] = (t[j + 2] - t[j]) / 3.0;
      if (j + 1 < inner_) gram_.first[j] = (t[j + 2] - t[j + 1]) / 6.0;
      rough_.diagonal[j] = rough(j, j);
      if (j + 1 < inner_) rough_.first[j] = rough(j, j + 1);
      if (j + 2 < inner_) rough_.second[j] = rough(j, j + 2);
      qty_[j] = (data.y[j + 2] - data.y[j + 1]) * inverse_gap_[j + 1] -
                (data.y[j + 1] - data.y[j]) * inverse_gap_[j];
    }
  }

  /// @param lambda  scaled; 0 interpolates, ∞ is the straight line.
  [[nodiscard]] SplineFit fit(double lambda) const {
    return lambda == kInfinity || inner_ == 0 ? straight_line() : spline(lambda);
  }

  /// A scaled λ that smooths nowhere, not even the narrowest interval.
  [[nodiscard]] double negligible_lambda() const {
    double steepest = 0.0;
    for (std::size_t j = 0; j < inner_; ++j) {
      steepest = std::max(steepest, rough_.diagonal[j] / gram_.diagonal[j]);
    }
    return 1e-4 / steepest;
  }

 private:
  /// Element (i, j) of Q, which has three in column j.
  [[nodiscard]] double q(std::size_t i, std::size_t j) const {
    if (i == j) return inverse_gap_[j];
    if (i == j + 1) return -inverse_gap_[j] - inverse_gap_[j + 1];
    return inverse_gap_[j + 1];
  }

  /// Element (j, k) of QᵀW⁻¹Q, j ≤ k ≤ j + 2.
  [[nodiscard]] double rough(std::size_t j, std::size_t k) const {
    double sum = 0.0;
    for (std::size_t i = k; i <= j + 2; ++i) sum += q(i, j) * q(i, k) / data_->w[i];
    return sum;
  }

  [[nodiscard]] SplineFit spline(double lambda) const {
    Bands b(inner_);
    for (std::size_t j = 0; j < inner_; ++j) {
      b.diagonal[j] = gram_.diagonal[j] + lambda * rough_.diagonal[j];
      b.first[j] = gram_.first[j] + lambda * rough_.first[j];
      b.second[j] = lambda * rough_.second[j];
    }
    factorise(b);
    SplineFit fit{.lambda = lambda, .value = data_->y, .second = Vector(data_->size(), 0.0)};
    const Vector gamma = solve(b, qty_);
    std::ranges::copy(gamma, fit.second.begin() + 1);
    add_residuals(lambda, gamma, fit);
    add_freedom(lambda, inverse_bands(b), fit);
    return fit;
  }

  void add_residuals(double lambda, const Vector& gamma, SplineFit& fit) const {
    fit.rss = data_->repeat_rss;
    for (std::size_t i = 0; i < data_->size(); ++i) {
      double weighted = 0.0;  // (Qγ)_i
      for (std::size_t j = i < 2 ? 0 : i - 2; j <= i && j < inner_; ++j) {
        weighted += q(i, j) * gamma[j];
      }
      const double residual = lambda * weighted / data_->w[i];
      fit.value[i] -= residual;
      fit.rss += data_->w[i] * residual * residual;
    }
  }

  /// edf = 2 + tr(RB⁻¹) and n − edf = λ tr(W⁻¹QB⁻¹Qᵀ): the same, but each accurate where it is
  /// small.
  void add_freedom(double lambda, const Bands& inverse, SplineFit& fit) const {
    fit.edf = 2.0;
    for (std::size_t j = 0; j < inner_; ++j) {
      fit.edf += gram_.diagonal[j] * inverse.diagonal[j] + 2.0 * gram_.first[j] * inverse.first[j];
    }
    fit.residual_dof = data_->repeats();
    for (std::size_t i = 0; i < data_->size(); ++i) {
      const double free = lambda * projection(inverse, i) / data_->w[i];
      fit.leverage.push_back(1.0 - free);
      fit.residual_dof += free;
    }
  }

  /// Element (i, i) of QB⁻¹Qᵀ.
  [[nodiscard]] double projection(const Bands& inverse, std::size_t i) const {
    double sum = 0.0;
    for (std::size_t j = i < 2 ? 0 : i - 2; j <= i && j < inner_; ++j) {
      sum += q(i, j) * q(i, j) * inverse.diagonal[j];
      if (j + 1 <= i && j + 1 < inner_) sum += 2.0 * q(i, j) * q(i, j + 1) * inverse.first[j];
      if (j + 2 <= i && j + 2 < inner_) sum += 2.0 * q(i, j) * q(i, j + 2) * inverse.second[j];
    }
    return sum;
  }

  [[nodiscard]] SplineFit straight_line() const {
    const Observations& d = *data_;
    const double sum_w = std::accumulate(d.w.begin(), d.w.end(), 0.0);
    const double mean_t = std::inner_product(d.w.begin(), d.w.end(), d.t.begin(), 0.0) / sum_w;
    const double mean_y = std::inner_product(d.w.begin(), d.w.end(), d.y.begin(), 0.0) / sum_w;
    double stt = 0.0;
    double sty = 0.0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      stt += d.w[i] * (d.t[i] - mean_t) * (d.t[i] - mean_t);
      sty += d.w[i] * (d.t[i] - mean_t) * (d.y[i] - mean_y);
    }
    SplineFit fit{.lambda = kInfinity, .second = Vector(d.size(), 0.0), .edf = 2.0};
    fit.rss = d.repeat_rss;
    fit.residual_dof = static_cast<double>(d.count) - 2.0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      const double from_mean = d.t[i] - mean_t;
      fit.value.push_back(mean_y + sty / stt * from_mean);
      fit.leverage.push_back(d.w[i] * (1.0 / sum_w + from_mean * from_mean / stt));
      fit.rss += d.w[i] * (d.y[i] - fit.value[i]) * (d.y[i] - fit.value[i]);
    }
    return fit;
  }

  const Observations* data_;
  std::size_t inner_;
  Vector inverse_gap_;  ///< 1/(t_{i+1} − t_i)
  Bands gram_;          ///< R
  Bands rough_;         ///< QᵀW⁻¹Q
  Vector qty_;
};

/// Result of a choice of λ, in scaled variables.
struct Choice {
  double lambda = 0.0;
  std::vector<GcvPoint> curve{};
  Summary summary{};
  std::vector<Warning> warnings{};
};

class Chooser {
 public:
  explicit Chooser(const Observations& data) : data_(&data), equations_(data) {}

  [[nodiscard]] const Reinsch& equations() const { return equations_; }

  Choice operator()(const Gcv& gcv) const {
    if (data_->size() < 4) {
      throw InputError("number of distinct x", static_cast<double>(data_->size()),
                       "must be at least 4 for cross-validation",
                       "Give λ, p or the degrees of freedom");
    }
    if (!(std::isfinite(gcv.edf_factor) && gcv.edf_factor >= 1.0)) {
      throw InputError("edf_factor", gcv.edf_factor, "must be 1 or more, and finite");
    }
    if (gcv.grid_per_decade < 1) {
      throw InputError("grid_per_decade", gcv.grid_per_decade, "must be at least 1");
    }
    Choice choice{.summary = summary("generalised cross-validation")};
    choice.curve = scan(gcv);
    const auto lowest = std::ranges::min_element(choice.curve, {}, &GcvPoint::gcv);
    if (lowest == choice.curve.begin() || lowest + 1 == choice.curve.end()) {
      end_of_grid(lowest == choice.curve.begin(), *lowest, choice);
    } else {
      refine(gcv, (lowest - 1)->scaled_lambda, (lowest + 1)->scaled_lambda, choice);
    }
    choice.summary.iterations += static_cast<int>(choice.curve.size());
    choice.summary.residual = gcv_slope(gcv, choice.lambda);
    return choice;
  }

  Choice operator()(const FixedLambda& fixed) const {
    if (!(fixed.lambda >= 0.0)) throw InputError("lambda", fixed.lambda, "must be 0 or more");
    return given(fixed.lambda, "fixed λ");
  }

  Choice operator()(const MatlabP& smoothing) const {
    const double p = smoothing.p;
    const double unit = smoothing.x_unit_in_metres;
    if (!(p >= 0.0 && p <= 1.0)) {
      throw InputError("smoothing factor p", p, "must lie in [0, 1]",
                       "0 is the straight line, 1 interpolates");
    }
    if (!(std::isfinite(unit) && unit > 0.0)) {
      throw InputError("x_unit_in_metres", unit, "must be positive and finite",
                       "p is meaningless without the unit of x it was found in");
    }
    return given(p == 0.0 ? kInfinity : (1.0 - p) / p * unit * unit * unit, "smoothing factor p");
  }

  Choice operator()(const TargetEdf& target) const {
    const auto n = static_cast<double>(data_->size());
    if (!(target.edf >= 2.0 && target.edf <= n)) {
      throw InputError("target edf", target.edf,
                       fmt::format("must lie in [2, {}], the number of distinct x", n));
    }
    if (target.edf == 2.0) return given(kInfinity, "target edf");
    if (target.edf == n) return given(0.0, "target edf");
    return search(target.edf);
  }

 private:
  static Summary summary(std::string_view how) {
    return {.stop = Stop::kConverged,
            .method = fmt::format("cubic smoothing spline, {}", how),
            .reason = "solved directly"};
  }

  Choice given(double lambda, std::string_view how) const {
    Choice choice{.lambda = lambda / data_->lambda_unit(), .summary = summary(how)};
    choice.summary.stop = Stop::kClosedForm;
    choice.summary.iterations = 1;
    return choice;
  }

  [[nodiscard]] GcvPoint gcv_point(const Gcv& gcv, double lambda) const {
    const SplineFit fit = equations_.fit(lambda);
    return {.lambda = lambda * data_->lambda_unit(),
            .scaled_lambda = lambda,
            .edf = fit.edf,
            .gcv = data_->mean_weight * fit.gcv(data_->count, gcv.edf_factor)};
  }

  [[nodiscard]] double log_gcv(const Gcv& gcv, double log_lambda) const {
    const double value = equations_.fit(std::exp(log_lambda)).gcv(data_->count, gcv.edf_factor);
    return std::log(std::min(value, std::numeric_limits<double>::max()));
  }

  /// From no smoothing up to the straight line or the largest λ.
  [[nodiscard]] std::vector<GcvPoint> scan(const Gcv& gcv) const {
    constexpr double kStraight = 2.001;  // edf
    std::vector<GcvPoint> curve;
    const double lowest = std::log10(equations_.negligible_lambda());
    for (int i = 0; curve.empty() || curve.back().edf > kStraight; ++i) {
      const double exponent = lowest + i / static_cast<double>(gcv.grid_per_decade);
      if (exponent > std::log10(kLargestScaledLambda)) break;
      curve.push_back(gcv_point(gcv, std::pow(10.0, exponent)));
    }
    return curve;
  }

  void refine(const Gcv& gcv, double low, double high, Choice& choice) const {
    constexpr int kBits = 24;  // a minimum is flat: half of the digits of a double is all there is
    std::uintmax_t iterations = 60;
    const auto [log_lambda, unused] =
        boost::math::tools::brent_find_minima([&](double u) { return log_gcv(gcv, u); },
                                              std::log(low), std::log(high), kBits, iterations);
    choice.lambda = std::exp(log_lambda);
    choice.summary.iterations = static_cast<int>(iterations);
    choice.summary.reason = "GCV is at its smallest";
    if (iterations >= 60) {
      choice.summary.stop = Stop::kLimit;
      choice.summary.reason = "too many steps in the search for the smallest GCV";
    }
  }

  static void end_of_grid(bool rough_end, const GcvPoint& point, Choice& choice) {
    choice.lambda = point.scaled_lambda;
    choice.summary.reason = rough_end ? "GCV falls all the way to interpolation"
                                      : "GCV falls all the way to the largest λ";
    choice.warnings.push_back(
        {"gcv_at_end_of_range",
         fmt::format("{}: {}.", choice.summary.reason,
                     rough_end ? "the data look free of noise, or are too few to tell; nothing is "
                                 "smoothed"
                               : fmt::format("{:.3f} degrees of freedom are left; no curvature "
                                             "beyond them stands out from the noise",
                                             point.edf))});
  }

  /// |d ln GCV/d ln λ|.
  [[nodiscard]] double gcv_slope(const Gcv& gcv, double lambda) const {
    constexpr double kStep = 1e-3;
    const double u = std::log(lambda);
    return std::abs(log_gcv(gcv, u + kStep) - log_gcv(gcv, u - kStep)) / (2.0 * kStep);
  }

  /// edf falls as λ rises.
  [[nodiscard]] Choice search(double target) const {
    Choice choice{.summary = summary("target edf")};
    const auto excess = [&](double log_lambda) {
      return equations_.fit(std::exp(log_lambda)).edf - target;
    };
    double low = std::log(equations_.negligible_lambda());
    while (excess(low) < 0.0 && low > -600.0) low -= 10.0;
    const double high = std::log(kLargestScaledLambda);
    if (excess(high) > 0.0) {
      choice.lambda = kLargestScaledLambda;
      choice.summary.stop = Stop::kNoProgress;
      choice.summary.reason = "the target needs a λ above the largest";
    } else {
      std::uintmax_t iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          excess, low, high, boost::math::tools::eps_tolerance<double>(48), iterations);
      choice.lambda = std::exp(0.5 * (bracket.first + bracket.second));
      choice.summary.iterations = static_cast<int>(iterations);
      choice.summary.reason = "the target is met";
    }
    choice.summary.residual = std::abs(excess(std::log(choice.lambda))) / target;
    return choice;
  }

  const Observations* data_;
  Reinsch equations_;
};

/// From scaled variables to those of the caller.
void fill(const Observations& data, const SplineFit& fit, SmoothingSplineResult& result) {
  const double h2 = data.spacing * data.spacing;
  Vector second = fit.second;
  for (double& value : second) value /= h2;
  result.spline = NaturalSpline(data.x, fit.value, std::move(second));
  result.scaled_lambda = fit.lambda;
  result.lambda = fit.lambda * data.lambda_unit();
  result.edf = fit.edf;
  result.leverage = fit.leverage;
  const bool noise_known = fit.residual_dof > 0.0;
  result.sigma_hat = noise_known ? std::sqrt(data.mean_weight * fit.rss / fit.residual_dof) : kNan;
  result.gcv = noise_known ? data.mean_weight * fit.gcv(data.count, 1.0) : kNan;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const double share = std::max(fit.leverage[i], 0.0) / (data.mean_weight * data.w[i]);
    result.standard_error.push_back(result.sigma_hat * std::sqrt(share));
  }
}

void lose_to_rounding(const Observations& data, SmoothingSplineResult& result) {
  result.summary.stop = Stop::kDoubtful;
  result.summary.reason =
      fmt::format("λ is too large for {} points: rounding leaves {:.3g} degrees of freedom",
                  data.size(), result.edf);
}

/// Above the largest λ the straight-line part of many points is lost in rounding; the curvature of
/// few is negligible before it comes to that. edf leaves [2, n] only where all digits are lost.
void check_rounding(const Observations& data, SmoothingSplineResult& result) {
  constexpr std::size_t kFew = 1000;  // the condition number stays below 0.2·n⁴
  if (result.scaled_lambda > kLargestScaledLambda && result.scaled_lambda != kInfinity) {
    result.warnings.push_back(
        {"smoothing_too_large",
         fmt::format(
             "the scaled λ {:.3g} is above {:.0e}: rounding may show in the curve. Take the "
             "straight line (p = 0) or merge neighbouring points.",
             result.scaled_lambda, kLargestScaledLambda)});
    if (data.size() > kFew) lose_to_rounding(data, result);
  }
  const auto n = static_cast<double>(data.size());
  const bool possible = result.edf >= 2.0 - 1e-6 && result.edf <= n * (1.0 + 1e-6);
  if (!possible) lose_to_rounding(data, result);
}

}  // namespace

SmoothingSplineResult fit_smoothing_spline(std::span<const double> x, std::span<const double> y,
                                           std::span<const double> weight,
                                           const Smoothing& smoothing) {
  const Stopwatch watch;
  const Observations data = prepare(x, y, weight);
  const Chooser chooser(data);
  Choice choice = std::visit(chooser, smoothing);
  SmoothingSplineResult result;
  result.gcv_curve = std::move(choice.curve);
  result.summary = std::move(choice.summary);
  result.warnings = std::move(choice.warnings);
  fill(data, chooser.equations().fit(choice.lambda), result);
  check_rounding(data, result);
  result.summary.wall_seconds = watch.seconds();
  return result;
}

}  // namespace microslip
