// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "microslip/algebra/qr.hpp"

namespace microslip {

/// An equivalent matrix of no more rows than columns: ‖Ax‖ is kept for any x, as A = QR.
[[nodiscard]] inline Eigen::MatrixXd fewer_rows(const Eigen::MatrixXd& rows) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
  return qr.matrixQR().topRows(std::min(rows.rows(), rows.cols())).triangularView<Eigen::Upper>();
}

}  // namespace microslip
