// SPDX-License-Identifier: MIT
#include "microslip/identify/records/joined_columns.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

JoinedColumns::JoinedColumns(const SettledRecords& settled) {
  const SmoothingProblem& problem = settled.model.problem();
  const QuadraticProgram::Solution& solution = settled.best.solution;
  const std::vector<Index> free = free_coefficients(solution);
  design_ = problem.design()(Eigen::all, free);
  ridge_ = problem.hessian(settled.best.lambda)(free, free) - design_.transpose() * design_;
  residual_ = problem.data() - problem.design() * solution.x;
  factor();
}

void JoinedColumns::add(const MatrixXd& columns) {
  const Index before = design_.cols();
  MatrixXd wider(design_.rows(), before + columns.cols());
  wider << design_, columns;
  design_ = std::move(wider);
  MatrixXd ridge = MatrixXd::Zero(design_.cols(), design_.cols());
  ridge.topLeftCorner(before, before) = ridge_;
  ridge_ = std::move(ridge);
  factor();
}

JoinedColumns::Explained JoinedColumns::explain(const MatrixXd& columns) const {
  const MatrixXd beside = columns - design_ * normal_.solve(design_.transpose() * columns);
  const MatrixXd gram = beside.transpose() * columns;
  const Eigen::LDLT<MatrixXd> own(gram);
  Explained found;
  const VectorXd score = beside.transpose() * residual_;
  found.coefficients = own.solve(score);
  const double explained = found.coefficients.dot(score);
  const double variance = std::max(left_ - explained, 0.0) / static_cast<double>(residual_.size());
  found.covariance = variance * own.solve(MatrixXd::Identity(gram.rows(), gram.rows()));
  found.gain = variance > 0.0 ? explained / variance : 0.0;
  return found;
}

void JoinedColumns::factor() {
  normal_.compute(design_.transpose() * design_ + ridge_);
  left_ = (residual_ - design_ * normal_.solve(design_.transpose() * residual_)).squaredNorm();
}

MatrixXd columns_among_all(const SettledRecords& settled, std::size_t record, MatrixXd columns) {
  Index first = 0;
  for (std::size_t r = 0; r < record; ++r) {
    first += static_cast<Index>(settled.records->records[r].rows().rows.size());
  }
  settled.model.weight(record, columns);
  MatrixXd all = MatrixXd::Zero(settled.model.problem().rows(), columns.cols());
  all.middleRows(first, columns.rows()) = columns;
  return all;
}

}  // namespace microslip
