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
  residual_ = problem.data() - problem.design() * solution.x;
  const MatrixXd gram = design_.transpose() * design_;
  const MatrixXd ridge = problem.hessian(settled.best.lambda)(free, free) - gram;
  normal_.compute(gram + ridge);
  left_ = (residual_ - design_ * normal_.solve(design_.transpose() * residual_)).squaredNorm();
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
  return found;
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
