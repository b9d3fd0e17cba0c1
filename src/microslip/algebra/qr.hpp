// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/QR>

#include "microslip/algebra/cholesky.hpp"

// Eigen's orthogonal factors, compiled once: included in place of <Eigen/QR>.

namespace Eigen {

MICROSLIP_INSTANCE template void HouseholderQR<MatrixXd>::computeInPlace();

MICROSLIP_INSTANCE template void ColPivHouseholderQR<MatrixXd>::computeInPlace();
MICROSLIP_INSTANCE template void ColPivHouseholderQR<MatrixXd>::_solve_impl(const VectorXd&,
                                                                            VectorXd&) const;

MICROSLIP_INSTANCE template void CompleteOrthogonalDecomposition<MatrixXd>::computeInPlace();
MICROSLIP_INSTANCE template void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(
    const VectorXd&, VectorXd&) const;

}  // namespace Eigen
