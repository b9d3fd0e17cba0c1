// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SVD>

#include "microslip/algebra/qr.hpp"

// Eigen's singular values, compiled once: included in place of <Eigen/SVD>.

namespace Eigen {

MICROSLIP_INSTANCE template JacobiSVD<MatrixXd>& JacobiSVD<MatrixXd>::compute(const MatrixXd&,
                                                                              unsigned int);
MICROSLIP_INSTANCE template JacobiSVD<MatrixXcd>& JacobiSVD<MatrixXcd>::compute(const MatrixXcd&,
                                                                                unsigned int);

}  // namespace Eigen
