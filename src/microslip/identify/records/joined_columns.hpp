// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/core.hpp"
#include "microslip/identify/records/record_settling.hpp"

/// @file
/// What further columns would explain of records beside the joint. Internal: Eigen stays out of the
/// installed headers.

namespace microslip {

/// The joint's columns as far as they are free, with others that join them.
class JoinedColumns {
 public:
  explicit JoinedColumns(const SettledRecords& settled);

  /// The part that columns would explain.
  struct Explained {
    Eigen::VectorXd coefficients = {};
    Eigen::MatrixXd covariance = {};  ///< of coefficients, by noise
  };
  /// @param columns  weighted as columns_among_all().
  [[nodiscard]] Explained explain(const Eigen::MatrixXd& columns) const;

 private:
  Eigen::MatrixXd design_;
  Eigen::VectorXd residual_;
  Eigen::LDLT<Eigen::MatrixXd> normal_;  // of them
  double left_ = 0.0;                    // weighted sum of squares, without further columns
};

/// The columns of one record among the rows of all, weighted as its rows are.
/// @param record   its index. @param columns  of its rows, over k₀X.
[[nodiscard]] Eigen::MatrixXd columns_among_all(const SettledRecords& settled, std::size_t record,
                                                Eigen::MatrixXd columns);

}  // namespace microslip
