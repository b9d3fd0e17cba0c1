// SPDX-License-Identifier: MIT
#include "microslip/modes/static_attachment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "microslip/algebra/eigenvalues.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Each solution from the shift leaves |σ|/(ω₁² + |σ|) of the error, 0.01 where the modes chose σ
/// by ω₁ and rounding let them.
constexpr int kMostSolutions = 60;
constexpr double kLoadTolerance = 1e-13;
/// Share of the static compliance: less is rounding of the modes.
constexpr double kLeastShare = 1e-10;
/// Above it a shape has no mass to speak of, and no place in a model.
constexpr double kHighestFrequency = 1e8;  // Hz

struct StaticDisplacement {
  MatrixXd displacement;
  VectorXd residuals;
};

/// The norm of each column over that of its load.
VectorXd over_loads(const MatrixXd& forces, const MatrixXd& loads) {
  return forces.colwise().norm().array() /
         loads.colwise().norm().array().max(std::numeric_limits<double>::min());
}

VectorXd rounding_of(const VibratingSystem& system, const MatrixXd& displacement,
                     const MatrixXd& loads) {
  MatrixXd forces(displacement.rows(), displacement.cols());
  for (Index j = 0; j < forces.cols(); ++j) {
    forces.col(j) = system.rounding_times(displacement.col(j));
  }
  return over_loads(forces, loads);
}

/// Solves by the factors of K − σM, with iterative refinement for the difference to K.
StaticDisplacement solve_statically(const VibratingSystem& system, const NaturalModes& modes,
                                    const MatrixXd& loads) {
  const auto rigid = modes.shapes.leftCols(static_cast<Index>(modes.rigid_bodies));
  const MatrixXd momenta = system.mass * rigid;
  const MatrixXd balanced = loads - momenta * (rigid.transpose() * loads);
  StaticDisplacement found{MatrixXd::Zero(loads.rows(), loads.cols()), {}};
  MatrixXd missing = balanced;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSolutions; ++i) {
    MatrixXd better = found.displacement + modes.factor->solve(missing);
    better -= rigid * (momenta.transpose() * better);
    missing = balanced - system.stiffness_times(better);
    missing -= momenta * (rigid.transpose() * missing);
    VectorXd residuals = over_loads(missing, loads);
    const double largest = residuals.maxCoeff();
    if (i > 0 && largest > 0.5 * before) break;  // rounding is all that is left
    found = {std::move(better), std::move(residuals)};
    before = largest;
    if (largest < kLoadTolerance) break;
  }
  return found;
}

/// (φ_iᵀb)/ω_i of the modes that strain; m × l.
MatrixXd modal_displacements(const NaturalModes& modes, const MatrixXd& loads) {
  MatrixXd share = modes.shapes.transpose() * loads;
  for (Index i = 0; i < share.rows(); ++i) {
    const bool strains = i >= static_cast<Index>(modes.rigid_bodies);
    share.row(i) *= strains ? 1.0 / std::sqrt(modes.eigenvalues(i)) : 0.0;
  }
  return share;
}

/// Columns less what of them lies along the modes; twice, as once leaves rounding.
void take_out_modes(const VibratingSystem& system, const NaturalModes& modes, MatrixXd& columns) {
  const MatrixXd momenta = system.mass * modes.shapes;
  for (int i = 0; i < 2; ++i) columns -= modes.shapes * (momenta.transpose() * columns);
}

}  // namespace

StaticAttachment attach_statically(const VibratingSystem& system, const NaturalModes& modes,
                                   const Eigen::SparseMatrix<double>& loads) {
  const MatrixXd load(loads);
  StaticDisplacement solved = solve_statically(system, modes, load);
  MatrixXd& beside = solved.displacement;
  StaticAttachment found;
  found.shapes = MatrixXd(system.size(), 0);
  found.residuals = std::move(solved.residuals);
  found.rounding = rounding_of(system, beside, load);
  found.compliance = load.cwiseProduct(beside).colwise().sum().transpose();
  found.in_modes = modal_displacements(modes, load).colwise().squaredNorm().transpose();
  take_out_modes(system, modes, beside);
  // Loads with nearly equal effects, or with none beyond the modes, get no shape.
  for (Index j = 0; j < beside.cols(); ++j) {
    if (found.compliance(j) > 0.0) beside.col(j) /= std::sqrt(found.compliance(j));
  }
  const MatrixXd energy = beside.transpose() * system.stiffness_times(beside);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> shares(
      (0.5 * (energy + energy.transpose())).eval());
  const auto kept = static_cast<Index>((shares.eigenvalues().array() > kLeastShare).count());
  found.massless = VectorXd::Zero(load.cols());
  if (kept == 0) return found;
  MatrixXd basis = beside * shares.eigenvectors().rightCols(kept);
  for (Index j = 0; j < kept; ++j) {
    basis.col(j) /= std::sqrt(shares.eigenvalues()(beside.cols() - kept + j));
  }
  // They have unit strain energy now: their modal masses are 1/ω².
  const MatrixXd masses = basis.transpose() * (system.mass * basis);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> ritz((0.5 * (masses + masses.transpose())).eval());
  const double least = std::pow(2.0 * std::numbers::pi * kHighestFrequency, -2.0);
  const auto moving = static_cast<Index>((ritz.eigenvalues().array() > least).count());
  const MatrixXd all = basis * ritz.eigenvectors();
  found.massless = (all.leftCols(kept - moving).transpose() * load).colwise().squaredNorm();
  found.eigenvalues = ritz.eigenvalues().tail(moving).cwiseInverse().reverse();
  found.shapes = all.rightCols(moving).rowwise().reverse();
  for (Index i = 0; i < moving; ++i) {
    found.shapes.col(i) *= std::sqrt(found.eigenvalues(i));
  }
  turn_positive(found.shapes);
  return found;
}

}  // namespace microslip
