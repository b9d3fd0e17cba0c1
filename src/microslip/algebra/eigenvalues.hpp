// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Eigenvalues>

#include "microslip/algebra/cholesky.hpp"

// Eigen's eigenvalues of symmetric matrices, compiled once: included in place of
// <Eigen/Eigenvalues>.

namespace Eigen {

MICROSLIP_INSTANCE template SelfAdjointEigenSolver<MatrixXd>&
SelfAdjointEigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, int);
MICROSLIP_INSTANCE template GeneralizedSelfAdjointEigenSolver<MatrixXd>&
GeneralizedSelfAdjointEigenSolver<MatrixXd>::compute(const MatrixXd&, const MatrixXd&, int);

}  // namespace Eigen
