// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>

#include "microslip/algebra/core.hpp"

// Eigen's LU factors of square matrices, compiled once: included in place of <Eigen/LU>.

namespace Eigen {

MICROSLIP_INSTANCE template void PartialPivLU<MatrixXd>::compute();
MICROSLIP_INSTANCE template void PartialPivLU<MatrixXcd>::compute();

}  // namespace Eigen
