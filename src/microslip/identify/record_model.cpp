// SPDX-License-Identifier: MIT
#include "microslip/identify/record_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "microslip/observe/record_rows.hpp"

namespace microslip {
namespace {

/// Nothing is sought below this share of the largest half range, nor is the lowest above that.
constexpr double kLeastLowest = 5e-3;
constexpr double kMostLowest = 0.05;
/// Slip displacements below so many deviations of the path are in its noise.
constexpr double kLowestDeviations = 3.0;

}  // namespace

ScaledRecords::ScaledRecords(std::span<const RecordEvidence> evidence, std::optional<double> known)
    : records(evidence), stiffness_known(known.has_value()), length(0.0), stiffness(0.0) {
  double finest = 0.0;
  for (const RecordEvidence& one : records) {
    length = std::max(length, one.rows().reach);
    for (const PathRow& row : one.rows().rows) {
      stiffness = std::max(stiffness, std::abs(row.force) / one.rows().reach);
    }
    const double resolved = kLowestDeviations * one.path().left;
    finest = finest == 0.0 ? resolved : std::min(finest, resolved);
  }
  if (known) stiffness = *known;
  lowest = std::clamp(finest / length, kLeastLowest, kMostLowest);
}

RecordModel::Block RecordModel::block_of(const RecordEvidence& record) const {
  const PathRows& path = record.rows();
  const auto rows = static_cast<Eigen::Index>(path.rows.size());
  const Eigen::Index size = basis_.size();
  Block block;
  block.design.resize(rows, size + (records_->stiffness_known ? 0 : 1) + (pass_.viscous ? 1 : 0));
  block.design.leftCols(size) = stop_rows(path, records_->length, basis_.knots()) * basis_.nodal();
  block.data.resize(rows);
  block.force.resize(rows);
  block.count.resize(rows);
  Eigen::VectorXd displacement(rows);
  Eigen::VectorXd velocity(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const PathRow& row = path.rows[static_cast<std::size_t>(i)];
    displacement(i) = row.displacement / records_->length;
    velocity(i) = row.velocity / records_->length;
    block.data(i) = row.force / (records_->stiffness * records_->length);
    block.force(i) = block.data(i);
    block.count(i) = static_cast<double>(row.count);
    if (i == 0 || row.group != path.rows[static_cast<std::size_t>(i) - 1].group) {
      block.group_begin.push_back(i);
    }
  }
  block.group_begin.push_back(rows);
  if (records_->stiffness_known) {
    block.design.leftCols(size) -= displacement * basis_.area().transpose();
    block.data -= displacement;
  } else {
    block.design.col(size) = displacement;
  }
  if (pass_.viscous) {
    block.design.rightCols(1) = velocity / record.measured().time_step;
  }
  return block;
}

/// Takes the offset of each group from columns of rows: their mean, each row as often as it has
/// samples.
void RecordModel::centre(const Block& block, Eigen::Ref<Eigen::MatrixXd> columns) {
  for (std::size_t g = 0; g + 1 < block.group_begin.size(); ++g) {
    const Eigen::Index from = block.group_begin[g];
    const Eigen::Index n = block.group_begin[g + 1] - from;
    const auto count = block.count.segment(from, n);
    const Eigen::RowVectorXd mean = count.transpose() * columns.middleRows(from, n) / count.sum();
    columns.middleRows(from, n).rowwise() -= mean;
  }
}

// Neighbouring rows are alike by ρ: what is new in each, with the deviation of 1 that it had.
void RecordModel::whiten(const Block& block, double scatter, double correlation,
                         Eigen::Ref<Eigen::MatrixXd> columns) {
  columns.array().colwise() *= block.count.array().sqrt() / scatter;
  if (correlation == 0.0) return;
  const double back = 1.0 / std::sqrt(1.0 - correlation * correlation);
  for (std::size_t g = 0; g + 1 < block.group_begin.size(); ++g) {
    for (Eigen::Index i = block.group_begin[g + 1] - 1; i > block.group_begin[g]; --i) {
      columns.row(i) = back * (columns.row(i) - correlation * columns.row(i - 1));
    }
  }
}

RecordModel::RecordModel(const ScaledRecords& records, const RecordPass& pass)
    : records_(&records),
      pass_(pass),
      basis_(records.lowest, 1.0, pass.exponent, pass.coefficients) {
  Eigen::Index rows = 0;
  for (const RecordEvidence& record : records.records) {
    blocks_.push_back(block_of(record));
    rows += blocks_.back().design.rows();
  }
  const Eigen::Index columns = blocks_.front().design.cols();
  // θ of 1 is a joint of which half the stiffness slips; c of 1 makes as much force as the joint.
  theta_scale_ = 0.5 / basis_.area().sum();
  if (pass_.viscous) {
    double largest = 0.0;
    for (const Block& block : blocks_) {
      largest = std::max(largest, block.design.rightCols(1).cwiseAbs().maxCoeff());
    }
    viscous_scale_ = largest > 0.0 ? 1.0 / largest : 1.0;
  }

  Eigen::MatrixXd design(rows, columns);
  Eigen::VectorXd data(rows);
  Eigen::Index at = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    block.design.leftCols(basis_.size()) *= theta_scale_;
    if (pass_.viscous) block.design.rightCols(1) *= viscous_scale_;
    const Eigen::Index n = block.design.rows();
    Eigen::MatrixXd both(n, columns + 1);
    both << block.design, block.data;
    centre(block, both);
    whiten(block, pass.scatter[b], pass.correlation[b], both);
    design.middleRows(at, n) = both.leftCols(columns);
    data.segment(at, n) = both.rightCols(1);
    at += n;
  }
  Eigen::MatrixXd penalty = Eigen::MatrixXd::Zero(basis_.size() - 2, columns);
  penalty.leftCols(basis_.size()) = basis_.second_differences();
  const Eigen::VectorXd budget =
      records.stiffness_known ? area_row() : Eigen::VectorXd::Zero(columns);
  problem_.emplace(std::move(design), std::move(data), std::move(penalty), budget,
                   2 + columns - basis_.size());
}

Eigen::MatrixXd RecordModel::density_matrix() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(basis_.nodal().rows(), blocks_[0].design.cols());
  matrix.leftCols(basis_.size()) = theta_scale_ * basis_.nodal();
  return matrix;
}

Eigen::VectorXd RecordModel::area_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(blocks_[0].design.cols());
  row.head(basis_.size()) = theta_scale_ * basis_.area();
  return row;
}

Eigen::VectorXd RecordModel::elastic_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(blocks_[0].design.cols());
  if (!records_->stiffness_known) row(basis_.size()) = 1.0;
  return row;
}

Eigen::VectorXd RecordModel::viscous_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(blocks_[0].design.cols());
  if (pass_.viscous) row(row.size() - 1) = viscous_scale_;
  return row;
}

void RecordModel::weight(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const {
  centre(blocks_[record], columns);
  whiten(blocks_[record], pass_.scatter[record], pass_.correlation[record], columns);
}

void RecordModel::centre(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const {
  centre(blocks_[record], columns);
}

Eigen::VectorXd RecordModel::found(std::size_t record, const Eigen::VectorXd& x) const {
  const Block& block = blocks_[record];
  // Where k is known its share of the force is not in the design.
  return block.design * x + (block.force - block.data);
}

Eigen::VectorXd RecordModel::residual(std::size_t record, const Eigen::VectorXd& x) const {
  const Block& block = blocks_[record];
  Eigen::VectorXd left = block.data - block.design * x;
  centre(block, left);
  return left;
}

double RecordModel::force_norm(std::size_t record) const {
  const Block& block = blocks_[record];
  Eigen::VectorXd force = block.force;
  centre(block, force);
  return force.norm();
}

Eigen::VectorXd RecordModel::offsets(std::size_t record, const Eigen::VectorXd& x) const {
  const Block& block = blocks_[record];
  const Eigen::VectorXd left = block.data - block.design * x;
  Eigen::VectorXd offset(static_cast<Eigen::Index>(block.group_begin.size()) - 1);
  for (Eigen::Index g = 0; g < offset.size(); ++g) {
    const Eigen::Index from = block.group_begin[static_cast<std::size_t>(g)];
    const Eigen::Index n = block.group_begin[static_cast<std::size_t>(g) + 1] - from;
    offset(g) = left.segment(from, n).dot(block.count.segment(from, n)) /
                block.count.segment(from, n).sum();
  }
  return offset;
}

}  // namespace microslip
