// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/possible_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/identify/posterior/density_posterior.hpp"
#include "microslip/identify/posterior/plain_matrix_view.hpp"
#include "microslip/identify/posterior/possible_coefficients.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// −2 ln p of the coefficients above its minimum: of three deviations.
constexpr double kThreeDeviations = 9.0;

/// 1 − k_eq/k at two amplitudes, as rows of the coefficients.
Eigen::MatrixXd softening_of(const InversionResult& result, double stiffness, double from,
                             double to) {
  const DensityPosterior& posterior = result.posterior;
  const double force = stiffness * to;
  std::vector<double> knots;  // the first is 0, to where the density is constant
  for (std::size_t i = 1; i < posterior.slip_force.size(); ++i) {
    knots.push_back(posterior.slip_force[i] / force);
  }
  const Eigen::Vector2d amplitude(from / to, 1.0);
  const auto density = matrix_of(posterior.density);
  Eigen::MatrixXd rows =
      force * softening_rows(amplitude, knots) * density.bottomRows(density.rows() - 1);
  if (result.atom_slip_force) {
    rows += atom_softening(amplitude, *result.atom_slip_force / force) *
            view_of(posterior.atom_weight).transpose();
  }
  return rows;
}

/// Gradient of ½ ln(k_eq(A₁)/k_eq(A₂)).
Eigen::VectorXd gradient(const Eigen::MatrixXd& softening, const Eigen::VectorXd& x) {
  constexpr double kLeastStiffness = 1e-3;
  const Eigen::VectorXd left = (1.0 - (softening * x).array()).max(kLeastStiffness).matrix();
  return 0.5 * (softening.row(1) / left(1) - softening.row(0) / left(0)).transpose();
}

}  // namespace

Joint softest_joint(const InversionResult& result, double stiffness, double from, double to) {
  result.check();
  if (!(from > 0.0 && to > from)) {
    throw InputError("amplitude", from, "must be positive, and below the other");
  }
  const Eigen::MatrixXd softening = softening_of(result, stiffness, from, to);
  const std::vector<double> found = result.posterior.extreme(
      [&](const std::vector<double>& at) -> std::vector<double> {
        const Eigen::VectorXd slope = gradient(softening, view_of(at));
        return {slope.begin(), slope.end()};
      },
      kThreeDeviations);
  const Eigen::VectorXd x = view_of(found);
  const Eigen::VectorXd at_knots = matrix_of(result.posterior.density) * x;
  InversionResult softest = result;
  softest.density.assign(at_knots.begin(), at_knots.end());
  softest.atom_weight = view_of(result.posterior.atom_weight).dot(x);
  return joint_of(softest, stiffness);
}

double least_area(const InversionResult& result) {
  result.check();
  std::vector<double> downwards = result.posterior.area;
  for (double& value : downwards) value = -value;
  const std::vector<double> x =
      result.posterior.extreme([&](const std::vector<double>&) { return downwards; },
                               PossibleCoefficients::kNineteenOfTwenty);
  return view_of(result.posterior.area).dot(view_of(x));
}

}  // namespace microslip
