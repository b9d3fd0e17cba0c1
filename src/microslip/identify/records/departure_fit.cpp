// SPDX-License-Identifier: MIT
#include "microslip/identify/records/departure_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/algebra/cholesky.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The smoothing that noise asks for would keep a joint from the shape that it has beside a
/// departure: what is left of another is no noise. A part of it keeps the program definite.
constexpr double kSmoothing = 1e-3;
constexpr double kRidge = 1e-11;
/// That of columns of a departure, which may be alike.
constexpr double kOwnRidge = 1e-9;
/// Correlation of neighbouring rows that is taken for that of noise.
constexpr double kMostAlike = 0.7;

RecordPass weighed_alike(RecordPass settings) {
  std::ranges::fill(settings.correlation, 0.0);
  return settings;
}

/// Columns of length 1 over that of the force.
MatrixXd of_length(MatrixXd columns, double length) {
  for (Index j = 0; j < columns.cols(); ++j) {
    const double own = columns.col(j).norm();
    if (own > 0.0) columns.col(j) *= length / own;
  }
  return columns;
}

MatrixXd gram_of(const MatrixXd& columns, const VectorXd& data) {
  MatrixXd all(data.size(), columns.cols() + 1);
  all << columns, data;
  return all.transpose() * all;
}

double neighbour_correlation(const VectorXd& left) {
  const Index n = left.size();
  const double alike =
      left.head(n - 1).dot(left.tail(n - 1)) / std::max(left.squaredNorm(), 1e-300);
  return std::clamp(alike, 0.0, kMostAlike);
}

}  // namespace

DepartureFit::DepartureFit(const SettledRecords& settled, std::size_t record)
    : records_(settled.records.get()),
      record_(record),
      model_(*settled.records, weighed_alike(settled.settings)) {
  const SmoothingProblem& problem = model_.problem();
  Index first = 0;
  for (std::size_t r = 0; r < record; ++r) {
    first += static_cast<Index>(records_->records[r].rows().rows.size());
  }
  const auto n = static_cast<Index>(records_->records[record].rows().rows.size());
  rows_.columns = problem.design().middleRows(first, n);
  rows_.limited.assign(static_cast<std::size_t>(rows_.columns.cols()), true);
  rows_.data = problem.data().segment(first, n);
  rows_.gram = gram_of(rows_.columns, rows_.data);
  const Index joint = problem.size();
  ridge_ =
      problem.hessian(kSmoothing * settled.best.lambda) - rows_.gram.topLeftCorner(joint, joint);
  ridge_.diagonal().array() += kRidge * rows_.columns.squaredNorm();
  linear_ = problem.linear() - rows_.gram.topRightCorner(joint, 1);
  other_square_ = problem.data().squaredNorm() - rows_.data.squaredNorm();
  const VectorXd none = VectorXd::Zero(joint);
  force_square_ =
      weighted(model_.found(record, none) + model_.residual(record, none)).squaredNorm();
  left_ = fit(rows_);
}

MatrixXd DepartureFit::weighted(MatrixXd columns) const {
  if (columns.cols() > 0) model_.weight(record_, columns);
  return columns;
}

// Where k is known its force on the path is in the data, and the joint has what it lacks of that.
DepartureFit::Rows DepartureFit::moved(const MovedPath& path) const {
  Rows rows = rows_;
  MatrixXd change = path.stop * model_.density_matrix();
  if (records_->stiffness_known) {
    change -= path.displacement * model_.area_row().transpose();
    rows.data -= weighted(path.displacement).col(0);
  } else {
    change += path.displacement * model_.elastic_row().transpose();
  }
  rows.columns.leftCols(change.cols()) += weighted(change);
  rows.gram = gram_of(rows.columns, rows.data);
  return rows;
}

DepartureFit::Rows DepartureFit::joined(const DepartureColumns& columns) const {
  Rows rows = columns.moved ? moved(*columns.moved) : rows_;
  const Index before = rows.columns.cols();
  const auto n = rows.data.size();
  MatrixXd further(n, columns.limited.cols() + columns.free.cols());
  if (further.cols() == 0) return rows;
  if (columns.limited.cols() > 0) further.leftCols(columns.limited.cols()) = columns.limited;
  if (columns.free.cols() > 0) further.rightCols(columns.free.cols()) = columns.free;
  further = of_length(weighted(std::move(further)), std::sqrt(force_square_));
  const Index width = before + further.cols();
  MatrixXd gram(width + 1, width + 1);
  gram.topLeftCorner(before, before) = rows.gram.topLeftCorner(before, before);
  gram.block(0, before, before, further.cols()) = rows.columns.transpose() * further;
  gram.block(before, before, further.cols(), further.cols()) = further.transpose() * further;
  gram.block(0, width, before, 1) = rows.gram.topRightCorner(before, 1);
  gram.block(before, width, further.cols(), 1) = further.transpose() * rows.data;
  gram(width, width) = rows.gram(before, before);
  gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
  rows.gram = std::move(gram);
  rows.columns.conservativeResize(Eigen::NoChange, width);
  rows.columns.rightCols(further.cols()) = further;
  rows.limited.insert(rows.limited.end(), static_cast<std::size_t>(columns.limited.cols()), true);
  rows.limited.insert(rows.limited.end(), static_cast<std::size_t>(columns.free.cols()), false);
  return rows;
}

// The free columns are eliminated: what remains is a program with x ≥ 0.
DepartureFit::Left DepartureFit::fit(const Rows& rows) const {
  std::vector<Index> limited;
  std::vector<Index> free;
  for (std::size_t j = 0; j < rows.limited.size(); ++j) {
    (rows.limited[j] ? limited : free).push_back(static_cast<Index>(j));
  }
  const Index data = rows.columns.cols();
  const Index joint = ridge_.cols();
  MatrixXd normal = rows.gram;
  normal.topLeftCorner(joint, joint) += ridge_;
  normal.block(0, data, joint, 1) += linear_;
  for (Index j = joint; j < data; ++j) normal(j, j) *= 1.0 + kOwnRidge;
  double square = normal(data, data) + other_square_;
  MatrixXd hessian = normal(limited, limited);
  VectorXd linear = normal(limited, data);
  VectorXd taken;
  MatrixXd shared;
  if (!free.empty()) {
    const Eigen::LDLT<MatrixXd> factor(normal(free, free));
    const MatrixXd cross = normal(free, limited);
    const VectorXd right = normal(free, data);
    shared = factor.solve(cross);
    taken = factor.solve(right);
    hessian -= cross.transpose() * shared;
    linear -= cross.transpose() * taken;
    square -= right.dot(taken);
  }
  VectorXd budget = VectorXd::Zero(linear.size());
  budget.head(joint) = model_.problem().area();
  QuadraticProgram program(budget, 1.0);
  const QuadraticProgram::Solution solution =
      program.solve(hessian, linear, std::vector<bool>(limited.size(), true));
  VectorXd left = rows.data - rows.columns(Eigen::all, limited) * solution.x;
  if (!free.empty()) left -= rows.columns(Eigen::all, free) * (taken - shared * solution.x);
  const double objective =
      std::max(square - solution.x.dot(2.0 * linear - hessian * solution.x), left.squaredNorm());
  const double alike = neighbour_correlation(left);
  const auto n = static_cast<double>(left.size());
  Left found;
  found.share = std::sqrt(objective / force_square_);
  found.noise = std::sqrt(left.squaredNorm() / force_square_ * (1.0 + alike) / (1.0 - alike) / n);
  return found;
}

DepartureFit::Left DepartureFit::with(const DepartureColumns& columns) const {
  return fit(joined(columns));
}

void DepartureFit::add(const DepartureColumns& columns) {
  rows_ = joined(columns);
  left_ = fit(rows_);
}

}  // namespace microslip
