// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/held_modes.hpp"

#include <cmath>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/eigenvalues.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A generalised inverse of a stiffness: unrestrained motions are 0. In the scale of its
/// diagonal, for modes whose frequencies lie decades apart.
MatrixXd inverse_of_held(const MatrixXd& stiffness) {
  if (stiffness.size() == 0) return stiffness;  // Eigen has no solver for it
  VectorXd scale = stiffness.diagonal();
  for (double& value : scale) value = value > 0.0 ? 1.0 / std::sqrt(value) : 0.0;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      (scale.asDiagonal() * stiffness * scale.asDiagonal()).eval());
  VectorXd inverse = solver.eigenvalues();
  for (double& value : inverse) value = value > 1e-12 ? 1.0 / value : 0.0;
  const MatrixXd vectors = scale.asDiagonal() * solver.eigenvectors();
  return vectors * inverse.asDiagonal() * vectors.transpose();
}

/// The modes by how stiff they are against the springs. The rounding of an elimination is that of
/// a double over the ratio.
struct Division {
  std::vector<Index> stiff;
  std::vector<Index> soft;
};

Division divided(const VectorXd& stiffness, const VectorXd& held) {
  constexpr double kSoft = 1e-6;
  Division modes;
  for (Index i = 0; i < stiffness.size(); ++i) {
    const bool is_stiff = stiffness[i] > kSoft * held[i];
    (is_stiff ? modes.stiff : modes.soft).push_back(i);
  }
  return modes;
}

/// (k⁻¹ + G)⁻¹ = k^½(I + k^½Gk^½)⁻¹k^½, whose eigenvalues are at least 1.
MatrixXd in_series(const VectorXd& springs, const MatrixXd& flexibility) {
  const VectorXd roots = springs.cwiseSqrt();
  MatrixXd sum = roots.asDiagonal() * flexibility * roots.asDiagonal();
  sum.diagonal().array() += 1.0;
  const Eigen::LLT<MatrixXd> factors(sum);
  return roots.asDiagonal() * factors.solve(MatrixXd(roots.asDiagonal()));
}

}  // namespace

MatrixXd held_displacements(const VectorXd& stiffness, const MatrixXd& shapes,
                            const VectorXd& springs, const MatrixXd& loads) {
  const Division modes = divided(stiffness, shapes.cwiseAbs2() * springs);
  const MatrixXd stiff_shapes = shapes(modes.stiff, Eigen::all);
  const MatrixXd soft_shapes = shapes(modes.soft, Eigen::all);
  const VectorXd flexibility = stiffness(modes.stiff).cwiseInverse();
  const MatrixXd stiff_moved = flexibility.asDiagonal() * stiff_shapes;
  const MatrixXd series = in_series(springs, stiff_shapes.transpose() * stiff_moved);
  const MatrixXd clamped = series * (stiff_moved.transpose() * loads(modes.stiff, Eigen::all));

  MatrixXd soft_stiffness = soft_shapes * series * soft_shapes.transpose();
  soft_stiffness.diagonal() += stiffness(modes.soft);
  const MatrixXd soft =
      inverse_of_held(soft_stiffness) * (loads(modes.soft, Eigen::all) - soft_shapes * clamped);
  const MatrixXd tensions = clamped + series * (soft_shapes.transpose() * soft);

  MatrixXd displacements(loads.rows(), loads.cols());
  displacements(modes.soft, Eigen::all) = soft;
  displacements(modes.stiff, Eigen::all) =
      flexibility.asDiagonal() * loads(modes.stiff, Eigen::all) - stiff_moved * tensions;
  return displacements;
}

}  // namespace microslip
