// SPDX-License-Identifier: MIT
#include "microslip/observe/path_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/median.hpp"

namespace microslip {
namespace {

/// The shortest window at an end, in samples, and how much longer the next one is.
constexpr std::size_t kShortestEnd = 6;
constexpr double kLonger = 1.25;
/// Powers of a polynomial at an end. It is unbiased up to so many deviations of the next power; no
/// longer window is tried where that has more, or the residuals have, than noise ever has.
constexpr std::array<Eigen::Index, 2> kEndPowers = {1, 2};
constexpr double kUnbiased = 1.5;
constexpr double kMostDeviations = 5.0;

/// Standard deviation by the median of differences of an order.
double by_differences(std::span<const double> path, int order) {
  std::vector<double> values(path.begin(), path.end());
  double scale = 1.0;  // √C(2d, d)
  for (int d = 1; d <= order; ++d) {
    for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i] = values[i + 1] - values[i];
    values.pop_back();
    scale *= std::sqrt(2.0 * (2.0 * d - 1.0) / d);
  }
  for (double& value : values) value = std::abs(value);
  constexpr double kMedianOfNormal = 0.6744897501960817;
  return median(std::move(values)) / (scale * kMedianOfNormal);
}

/// A polynomial at the first of its samples.
struct PolynomialEnd {
  double value;
  double variance;  ///< over that of a sample
  double next;      ///< what the next power would add, over its deviation
};

/// The polynomial of a power through samples of a noise; nothing where they do not follow it.
std::optional<PolynomialEnd> polynomial_end(std::span<const double> samples, Eigen::Index power,
                                            double noise) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd powers(n, power + 2);
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    values(i) = samples[static_cast<std::size_t>(i)] - samples.front();
    for (Eigen::Index j = 0; j < powers.cols(); ++j) {
      powers(i, j) =
          std::pow(static_cast<double>(i) / static_cast<double>(n - 1), static_cast<double>(j));
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> wider(powers.transpose() * powers);
  const Eigen::VectorXd with_next = wider.solve(powers.transpose() * values);
  const Eigen::VectorXd last = Eigen::VectorXd::Unit(powers.cols(), power + 1);
  const double next =
      std::abs(with_next(power + 1)) / (noise * std::sqrt(last.dot(wider.solve(last))));
  if (next > kMostDeviations) return {};
  const double left = (values - powers * with_next).squaredNorm() / (noise * noise);
  const double freedom = static_cast<double>(n - powers.cols());
  if (left > freedom + kMostDeviations * std::sqrt(2.0 * freedom)) return {};
  const Eigen::MatrixXd own = powers.leftCols(power + 1);
  const Eigen::LLT<Eigen::MatrixXd> gram(own.transpose() * own);
  const Eigen::VectorXd first = Eigen::VectorXd::Unit(power + 1, 0);
  return PolynomialEnd{samples.front() + gram.solve(own.transpose() * values)(0),
                       first.dot(gram.solve(first)), next};
}

}  // namespace

double noise_of_path(std::span<const double> path) {
  const auto [low, high] = std::ranges::minmax(path);
  double noise = std::numeric_limits<double>::infinity();
  for (const int order : {2, 4, 6}) noise = std::min(noise, by_differences(path, order));
  return std::max(noise, 64.0 * std::numeric_limits<double>::epsilon() * (high - low));
}

double first_without_noise(std::span<const double> path) {
  const double noise = noise_of_path(path);
  double value = path.front();
  double least = 1.0;  // variance of the value over that of a sample
  for (const Eigen::Index power : kEndPowers) {
    for (std::size_t n = kShortestEnd; n <= path.size();
         n = static_cast<std::size_t>(std::ceil(kLonger * static_cast<double>(n)))) {
      const auto end = polynomial_end(path.first(n), power, noise);
      if (!end) break;
      if (end->next > kUnbiased || end->variance >= least) continue;
      value = end->value;
      least = end->variance;
    }
  }
  return value;
}

}  // namespace microslip
