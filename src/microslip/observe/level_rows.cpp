// SPDX-License-Identifier: MIT
#include "microslip/observe/level_rows.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

/// Contribution of one hat function, linear between knots, from one cell: ∫ kernel·(ends'
/// shares).
struct CellIntegrals {
  double left;   ///< weight of the value at the cell's left end
  double right;  ///< and of that at its right end
};

/// ∫ 4t(a − t)·N dt over the part of [l, r] below a. Two Gauss points integrate the cubic exactly.
CellIntegrals dissipation_cell(double a, double l, double r) {
  const double end = std::min(a, r);
  if (!(end > l)) return {0.0, 0.0};
  const double half = 0.5 * (end - l);
  const double centre = 0.5 * (end + l);
  CellIntegrals sum{0.0, 0.0};
  for (const double sign : {-1.0, 1.0}) {
    const double t = centre + sign * half / std::sqrt(3.0);
    const double value = 4.0 * t * (a - t) * half;
    const double share = (t - l) / (r - l);
    sum.left += value * (1.0 - share);
    sum.right += value * share;
  }
  return sum;
}

/// g of an element that slips at sin²α of the amplitude.
double kept_share(double alpha) {
  return (2.0 * alpha - 0.5 * std::sin(4.0 * alpha)) / std::numbers::pi;
}

/// ∫ (1 − g(t/a))·N dt over the part of [l, r] below a: only elements that slip soften. Over α with
/// t = a sin²α the integrand has no singularity, so that few Gauss points do; differences of
/// antiderivatives would cancel in narrow cells.
CellIntegrals softening_cell(double a, double l, double r) {
  const double end = std::min(a, r);
  if (!(end > l)) return {0.0, 0.0};
  const double low = std::asin(std::sqrt(l / a));
  const double high = std::asin(std::sqrt(end / a));
  CellIntegrals sum{0.0, 0.0};
  const auto integrand = [&](double alpha) {
    const double sine = std::sin(alpha);
    const double t = std::clamp(a * sine * sine, l, end);
    const double dt = a * std::sin(2.0 * alpha);
    const double share = (t - l) / (r - l);
    const double value = (1.0 - kept_share(alpha)) * dt;
    return std::array{value * (1.0 - share), value * share};
  };
  const auto add = [&](const auto& abscissa, const auto& weights) {
    const double half = 0.5 * (high - low);
    const double centre = 0.5 * (high + low);
    for (std::size_t i = 0; i < abscissa.size(); ++i) {
      for (const double sign : {-1.0, 1.0}) {
        if (abscissa[i] == 0.0 && sign > 0.0) continue;
        const auto [left, right] = integrand(centre + sign * half * abscissa[i]);
        sum.left += half * weights[i] * left;
        sum.right += half * weights[i] * right;
      }
    }
  };
  using boost::math::quadrature::gauss;
  if (high - low < 0.15) {
    add(gauss<double, 7>::abscissa(), gauss<double, 7>::weights());
  } else {
    add(gauss<double, 20>::abscissa(), gauss<double, 20>::weights());
  }
  return sum;
}

/// The matrix amplitudes × knots of a kernel's cell integrals; below the first knot the density has
/// the value of that knot.
template <typename Cell>
Eigen::MatrixXd over_knots(const Eigen::VectorXd& amplitude, const std::vector<double>& knots,
                           const Cell& cell) {
  const auto count = static_cast<Eigen::Index>(knots.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(amplitude.size(), count);
  for (Eigen::Index i = 0; i < amplitude.size(); ++i) {
    const CellIntegrals below = cell(amplitude(i), 0.0, knots.front());
    matrix(i, 0) += below.left + below.right;
    for (Eigen::Index j = 0; j + 1 < count; ++j) {
      const auto [left, right] = cell(amplitude(i), knots[static_cast<std::size_t>(j)],
                                      knots[static_cast<std::size_t>(j) + 1]);
      matrix(i, j) += left;
      matrix(i, j + 1) += right;
    }
  }
  return matrix;
}

}  // namespace

Eigen::MatrixXd dissipation_rows(const Eigen::VectorXd& amplitude,
                                 const std::vector<double>& knots) {
  return over_knots(amplitude, knots, dissipation_cell);
}

Eigen::MatrixXd softening_rows(const Eigen::VectorXd& amplitude, const std::vector<double>& knots) {
  return over_knots(amplitude, knots, softening_cell);
}

Eigen::VectorXd atom_dissipation(const Eigen::VectorXd& amplitude, double s) {
  return (4.0 * s * (amplitude.array() - s)).max(0.0);
}

Eigen::VectorXd atom_softening(const Eigen::VectorXd& amplitude, double s) {
  return amplitude.unaryExpr([s](double a) { return a > s ? 1.0 - jenkins_secant(s / a) : 0.0; });
}

}  // namespace microslip
