// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/algebra/core.hpp"
#include "microslip/identify/posterior/plain_matrix.hpp"

namespace microslip {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A plain matrix for Eigen; it must outlive the view. Internal, as eigen_view.hpp.
[[nodiscard]] inline Eigen::Map<const RowMajor> matrix_of(const PlainMatrix& m) {
  return {m.values.data(), static_cast<Eigen::Index>(m.rows()),
          static_cast<Eigen::Index>(m.columns)};
}

}  // namespace microslip
