// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

#include <Eigen/Core>

#include "microslip/algebra/instance.hpp"

// Eigen's matrices, with the kernels of their products and of triangular solutions compiled once
// for the whole library: included in place of <Eigen/Core>. The code is Eigen's own, so that
// each bit of a result is as without this header; a kernel that is not listed works as well and
// is compiled where it is used.
//
// These kernels are class templates of Eigen 3.4 that are never inlined. Its traits give the
// sizes of blocks and packets, so that the list fits any target.

namespace Eigen::internal {

using Complex = std::complex<double>;

// C += α·A·B by blocks.
#define MICROSLIP_BLOCK_KERNEL(Left, Right)                                             \
  MICROSLIP_INSTANCE template struct gebp_kernel<                                       \
      Left, Right, Index,                                                               \
      blas_data_mapper<ScalarBinaryOpTraits<Left, Right>::ReturnType, Index, ColMajor>, \
      gebp_traits<Left, Right>::mr, gebp_traits<Left, Right>::nr, false, false>;

MICROSLIP_BLOCK_KERNEL(double, double)
MICROSLIP_BLOCK_KERNEL(Complex, Complex)
MICROSLIP_BLOCK_KERNEL(double, Complex)
MICROSLIP_BLOCK_KERNEL(Complex, double)

// y += α·A·x, of A as it is and of Aᵀ.
#define MICROSLIP_MATRIX_VECTOR(Left, Right, Order, VectorOrder)                    \
  MICROSLIP_INSTANCE template struct general_matrix_vector_product<                 \
      Index, Left, const_blas_data_mapper<Left, Index, Order>, Order, false, Right, \
      const_blas_data_mapper<Right, Index, VectorOrder>, false>;

MICROSLIP_MATRIX_VECTOR(double, double, ColMajor, RowMajor)
MICROSLIP_MATRIX_VECTOR(double, double, ColMajor, ColMajor)
MICROSLIP_MATRIX_VECTOR(double, double, RowMajor, ColMajor)
MICROSLIP_MATRIX_VECTOR(double, Complex, ColMajor, RowMajor)
MICROSLIP_MATRIX_VECTOR(double, Complex, RowMajor, ColMajor)
MICROSLIP_MATRIX_VECTOR(Complex, double, RowMajor, ColMajor)
MICROSLIP_MATRIX_VECTOR(Complex, Complex, ColMajor, RowMajor)
MICROSLIP_MATRIX_VECTOR(Complex, Complex, ColMajor, ColMajor)
MICROSLIP_MATRIX_VECTOR(Complex, Complex, RowMajor, ColMajor)

// T⁻¹·B and B·T⁻¹ of a triangular T.
#define MICROSLIP_TRIANGULAR_SOLUTION(Scalar, Side, Mode, Order)                               \
  MICROSLIP_INSTANCE template struct triangular_solve_matrix<Scalar, Index, Side, Mode, false, \
                                                             Order, ColMajor, 1>;

MICROSLIP_TRIANGULAR_SOLUTION(double, OnTheLeft, Lower, ColMajor)
MICROSLIP_TRIANGULAR_SOLUTION(double, OnTheLeft, UnitLower, ColMajor)
MICROSLIP_TRIANGULAR_SOLUTION(double, OnTheLeft, Upper, ColMajor)
MICROSLIP_TRIANGULAR_SOLUTION(double, OnTheLeft, Upper, RowMajor)
MICROSLIP_TRIANGULAR_SOLUTION(double, OnTheLeft, UnitUpper, RowMajor)
MICROSLIP_TRIANGULAR_SOLUTION(double, OnTheRight, Lower, ColMajor)
MICROSLIP_TRIANGULAR_SOLUTION(double, OnTheRight, Upper, RowMajor)
MICROSLIP_TRIANGULAR_SOLUTION(Complex, OnTheLeft, Lower, ColMajor)
MICROSLIP_TRIANGULAR_SOLUTION(Complex, OnTheLeft, UnitLower, ColMajor)
MICROSLIP_TRIANGULAR_SOLUTION(Complex, OnTheLeft, Upper, ColMajor)

}  // namespace Eigen::internal

#undef MICROSLIP_BLOCK_KERNEL
#undef MICROSLIP_MATRIX_VECTOR
#undef MICROSLIP_TRIANGULAR_SOLUTION
