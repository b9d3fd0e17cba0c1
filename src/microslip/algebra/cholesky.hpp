// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include "microslip/algebra/core.hpp"

// Eigen's factors of symmetric matrices, compiled once: included in place of <Eigen/Cholesky>.

namespace Eigen {

MICROSLIP_INSTANCE template LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
MICROSLIP_INSTANCE template void LLT<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;
MICROSLIP_INSTANCE template void LLT<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;

MICROSLIP_INSTANCE template LLT<Ref<MatrixXd>>& LLT<Ref<MatrixXd>>::compute(
    const EigenBase<MatrixXd>&);
MICROSLIP_INSTANCE template void LLT<Ref<MatrixXd>>::_solve_impl(const VectorXd&, VectorXd&) const;

MICROSLIP_INSTANCE template LLT<MatrixXcd>& LLT<MatrixXcd>::compute(const EigenBase<MatrixXcd>&);

MICROSLIP_INSTANCE template LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
MICROSLIP_INSTANCE template void LDLT<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;
MICROSLIP_INSTANCE template void LDLT<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;

}  // namespace Eigen
