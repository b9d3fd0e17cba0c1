// SPDX-License-Identifier: MIT
#include "microslip/observe/neighbour_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/median.hpp"

namespace microslip {
namespace {

constexpr double kMedianOfNormal = 0.6744897501960817;  // of |z|, z standard normal
/// The least number of points, of which each cubic takes five, that leaves five deviations.
constexpr std::size_t kFewestForCubics = 9;

void check_points(std::size_t n, std::size_t values) {
  if (n >= 3 && values == n) return;
  throw InputError("number of points", static_cast<double>(n),
                   "must be 3 or more, with one y each");
}

/// The deviation of point i from the polynomial through `reach` neighbours on either side, and the
/// standard deviation of that.
struct Deviation {
  double value;
  double std;
};

Deviation deviation_at(std::size_t i, std::size_t reach, std::span<const double> x,
                       std::span<const double> y, std::span<const double> sigma) {
  double predicted = 0.0;
  double variance = sigma[i] * sigma[i];
  for (std::size_t j = i - reach; j <= i + reach; ++j) {
    if (j == i) continue;
    double share = 1.0;  // of y_j in the polynomial of Lagrange
    for (std::size_t other = i - reach; other <= i + reach; ++other) {
      if (other != i && other != j) share *= (x[i] - x[other]) / (x[j] - x[other]);
    }
    predicted += share * y[j];
    variance += share * share * sigma[j] * sigma[j];
  }
  return {predicted - y[i], std::sqrt(variance)};
}

/// Median of the deviations over their standard deviations, as one of a normal variable.
double scatter_about(std::size_t reach, std::span<const double> x, std::span<const double> y,
                     std::span<const double> sigma) {
  std::vector<double> deviations;
  for (std::size_t i = reach; i + reach < x.size(); ++i) {
    const Deviation deviation = deviation_at(i, reach, x, y, sigma);
    deviations.push_back(std::abs(deviation.value) / deviation.std);
  }
  return median(std::move(deviations)) / kMedianOfNormal;
}

}  // namespace

double scatter_about_neighbours(std::span<const double> x, std::span<const double> y) {
  check_points(x.size(), y.size());
  return scatter_about(1, x, y, std::vector<double>(x.size(), 1.0));
}

double scatter_about_curve(std::span<const double> x, std::span<const double> y,
                           std::span<const double> sigma) {
  check_points(x.size(), y.size());
  check_points(x.size(), sigma.size());
  return scatter_about(x.size() < kFewestForCubics ? 1 : 2, x, y, sigma);
}

}  // namespace microslip
