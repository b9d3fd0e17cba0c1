// SPDX-License-Identifier: MIT
#include "microslip/modes/definite_pencil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Sweeps over all pairs of columns converge quadratically in the end; ten are many.
constexpr int kMostSweeps = 40;

double dense_rounding(Index size) {
  return static_cast<double>(size) * std::numeric_limits<double>::epsilon();
}

/// G of M = GGᵀ, of as many columns as M has rank: pivots at rounding of their diagonal have none.
MatrixXd mass_root(const MatrixXd& mass) {
  const Eigen::LDLT<MatrixXd> factor(mass);
  const VectorXd diagonal = factor.transpositionsP() * VectorXd(mass.diagonal());
  const MatrixXd lower = factor.matrixL();
  MatrixXd root(mass.rows(), mass.cols());
  Index rank = 0;
  for (Index j = 0; j < mass.cols(); ++j) {
    const double pivot = factor.vectorD()(j);
    if (!(pivot > dense_rounding(mass.rows()) * diagonal(j))) continue;
    root.col(rank++) = std::sqrt(pivot) * lower.col(j);
  }
  return factor.transpositionsP().transpose() * root.leftCols(rank);
}

/// Rotates two columns of y to orthogonal ones, and those of v with them.
/// @return whether there was anything to rotate.
bool rotate(Index p, Index q, MatrixXd& y, MatrixXd& v, VectorXd& squares) {
  const double shared = y.col(p).dot(y.col(q));
  const double tolerance = dense_rounding(y.rows()) * std::sqrt(squares(p)) * std::sqrt(squares(q));
  if (!(std::abs(shared) > tolerance)) return false;
  const double zeta = (squares(q) - squares(p)) / (2.0 * shared);
  const double tangent = std::copysign(1.0, zeta) / (std::abs(zeta) + std::hypot(1.0, zeta));
  const double cosine = 1.0 / std::hypot(1.0, tangent);
  const double sine = cosine * tangent;
  for (MatrixXd* matrix : {&y, &v}) {
    const VectorXd first = matrix->col(p);
    matrix->col(p) = cosine * first - sine * matrix->col(q);
    matrix->col(q) = sine * first + cosine * matrix->col(q);
  }
  squares(p) = y.col(p).squaredNorm();
  squares(q) = y.col(q).squaredNorm();
  return true;
}

/// Makes the columns of y orthogonal.
void orthogonalise(MatrixXd& y, MatrixXd& v) {
  VectorXd squares = y.colwise().squaredNorm();
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool rotated = false;
    for (Index p = 0; p < y.cols(); ++p) {
      for (Index q = p + 1; q < y.cols(); ++q) rotated = rotate(p, q, y, v, squares) || rotated;
    }
    if (!rotated) return;
  }
}

MatrixXd symmetric(const MatrixXd& matrix) { return 0.5 * (matrix + matrix.transpose()); }

}  // namespace

void refuse_negative_stiffness(std::optional<std::size_t> negative) {
  throw InputError(
      "stiffness matrix",
      negative ? fmt::format("{} negative eigenvalue{}", *negative, *negative == 1 ? "" : "s")
               : "not positive definite",
      "must have no negative eigenvalue beyond rounding",
      "Are the two matrices exchanged, entries missing or written with few digits?");
}

ModalPairs definite_pairs(const MatrixXd& stiffness, const MatrixXd& mass, double shift) {
  const MatrixXd k = symmetric(stiffness);
  const MatrixXd m = symmetric(mass);
  const Eigen::LLT<MatrixXd> factor((k - shift * m).eval());
  if (factor.info() != Eigen::Success) refuse_negative_stiffness(std::nullopt);
  const MatrixXd half = factor.matrixL().solve(mass_root(m));
  // A first approximation, of θ with ε of the largest: few rotations are left.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver((half * half.transpose()).eval());
  MatrixXd v = solver.eigenvectors().rowwise().reverse();
  MatrixXd y = half.transpose() * v;
  orthogonalise(y, v);
  const VectorXd theta = y.colwise().squaredNorm();
  std::vector<Index> order(static_cast<std::size_t>(theta.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, std::ranges::greater(), [&](Index i) { return theta(i); });
  order.resize(static_cast<std::size_t>(half.cols()));  // the rest moves without mass
  ModalPairs pairs;
  pairs.shapes = factor.matrixU().solve(v(Eigen::all, order));
  for (Index i = 0; i < pairs.shapes.cols(); ++i) {
    pairs.shapes.col(i) /= std::sqrt(pairs.shapes.col(i).dot(m * pairs.shapes.col(i)));
  }
  pairs.eigenvalues = pairs.shapes.cwiseProduct(k * pairs.shapes).colwise().sum().transpose();
  return pairs;
}

}  // namespace microslip
