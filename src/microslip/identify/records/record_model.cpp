// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/observe/level_rows.hpp"
#include "microslip/observe/record_rows.hpp"

namespace microslip {
namespace {

/// Nothing is sought below this share of the range of the density, nor is the lowest above that.
constexpr double kLeastLowest = 5e-3;
constexpr double kMostLowest = 0.05;
/// Slip displacements below so many deviations of the path are in its noise.
constexpr double kLowestDeviations = 3.0;

}  // namespace

ScaledRecords::ScaledRecords(const JointEvidence& evidence, std::optional<double> known,
                             int coefficients_of_density)
    : records(evidence.records),
      levels(evidence.levels),
      coefficients(coefficients_of_density),
      stiffness_known(known.has_value()),
      length(0.0),
      stiffness(0.0),
      lowest(0.0) {
  finest = std::numeric_limits<double>::infinity();
  for (const RecordEvidence& one : records) {
    length = std::max(length, one.rows().reach);
    for (const PathRow& row : one.rows().rows) {
      stiffness = std::max(stiffness, std::abs(row.force) / one.rows().reach);
    }
    finest = std::min(finest, kLowestDeviations * one.path().left);
  }
  for (const LevelEvidence& one : levels) {
    length = std::max(length, one.levels().amplitude.back());
    finest = std::min(finest, one.levels().amplitude.front());
  }
  if (known) stiffness = *known;
  finest /= length;
  set_range();
}

// Even knots.
void ScaledRecords::set_range() {
  lowest = std::clamp(finest, kLeastLowest * top, kMostLowest * top);
  places.clear();
  for (int j = 0; j < coefficients; ++j) places.push_back(j);
  set_rows();
}

ScaledRecords ScaledRecords::up_to(double end) const {
  ScaledRecords other = *this;
  other.top = end;
  other.set_range();
  return other;
}

ScaledRecords ScaledRecords::with_knots(std::vector<double> at) const {
  ScaledRecords other = *this;
  other.places = std::move(at);
  other.set_rows();
  return other;
}

InversionBasis ScaledRecords::basis(double exponent) const {
  return {lowest, top, exponent, places};
}

void ScaledRecords::set_rows() {
  stop.clear();
  dissipation.clear();
  softening.clear();
  const std::vector<double> knots = basis(0.0).knots();
  for (const RecordEvidence& one : records) {
    stop.push_back(stop_rows(one.rows(), length, knots));
  }
  for (const LevelEvidence& one : levels) {
    const Eigen::VectorXd amplitude = view_of(one.levels().amplitude) / length;
    dissipation.push_back(dissipation_rows(amplitude, knots));
    softening.push_back(one.levels().secant_stiffness.empty()
                            ? Eigen::MatrixXd(0, dissipation.back().cols())
                            : softening_rows(amplitude, knots));
  }
}

RecordModel::Block RecordModel::block_of(std::size_t index) const {
  const RecordEvidence& record = records_->records[index];
  const PathRows& path = record.rows();
  const auto rows = static_cast<Eigen::Index>(path.rows.size());
  const Eigen::Index size = basis_.size();
  Block block;
  block.design.resize(rows, columns_);
  block.design.leftCols(size) = records_->stop[index] * basis_.nodal();
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
    const bool first = i == 0;
    const PathRow& before = path.rows[static_cast<std::size_t>(first ? 0 : i - 1)];
    if (first || row.group != before.group) block.group_begin.push_back(i);
    if (first || row.turns != before.turns) block.branch_begin.push_back(i);
  }
  block.group_begin.push_back(rows);
  block.branch_begin.push_back(rows);
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

Eigen::MatrixXd RecordModel::dissipation_matrix(const Eigen::MatrixXd& dissipation) const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(dissipation.rows(), columns_);
  matrix.leftCols(basis_.size()) = theta_scale_ * (dissipation * basis_.nodal());
  return matrix;
}

// k_eq = K_e + ∫ψ − ∫(1 − g)ψ.
Eigen::MatrixXd RecordModel::secant_matrix(const Eigen::MatrixXd& softening) const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(softening.rows(), columns_);
  matrix.leftCols(basis_.size()) = -theta_scale_ * (softening * basis_.nodal());
  if (records_->stiffness_known) return matrix;
  return matrix.rowwise() + (area_row() + elastic_row()).transpose();
}

// Noise in A acts through the slope of D, close to that of the power law d ∝ a^(3+χ₀).
RecordModel::LevelBlock RecordModel::level_block(std::size_t table) const {
  const LevelEvidence& evidence = records_->levels[table];
  const LevelPass& pass = pass_.levels[table];
  const Levels& levels = evidence.levels();
  LevelPrediction prediction;
  prediction.value = {pass.dissipation, levels.secant_stiffness};
  for (std::size_t i = 0; i < evidence.size() && evidence.amplitude_std_counts(); ++i) {
    prediction.change.dissipation.push_back((3.0 + pass_.exponent) * pass.dissipation[i] *
                                            levels.amplitude_std[i] / levels.amplitude[i]);
  }
  LevelBlock block;
  block.deviation = evidence.deviations(prediction, pass.scatter);
  const auto of_d = static_cast<Eigen::Index>(evidence.size());
  const auto of_k = static_cast<Eigen::Index>(levels.secant_stiffness.size());
  block.design.resize(of_d + of_k, columns_);
  block.data.resize(of_d + of_k);
  block.weight.resize(of_d + of_k);
  block.design.topRows(of_d) = dissipation_matrix(records_->dissipation[table]);
  block.data.head(of_d) = view_of(levels.dissipation) / records_->energy();
  block.weight.head(of_d) =
      records_->energy() * view_of(block.deviation.dissipation).cwiseInverse();
  if (of_k == 0) return block;
  block.design.bottomRows(of_k) = secant_matrix(records_->softening[table]);
  block.data.tail(of_k) =
      (view_of(levels.secant_stiffness) / records_->stiffness).array() - secant_given();
  block.weight.tail(of_k) =
      records_->stiffness * view_of(block.deviation.secant_stiffness).cwiseInverse();
  return block;
}

/// Subtracts the offset of each group from columns of rows: their mean, each row as often as it has
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

// The rows of a branch have 1 + g gᵀ, g by the error of its turn: 1 − (1 − 1/√(1 + g²)) g gᵀ/g²
// makes that 1.
void RecordModel::whiten(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const {
  set_independent(record, columns);
  if (pass_.by_turn.empty()) return;
  Eigen::MatrixXd shared = pass_.by_turn[record];
  set_independent(record, shared);
  const std::vector<Eigen::Index>& begin = blocks_[record].branch_begin;
  for (std::size_t b = 0; b + 1 < begin.size(); ++b) {
    const auto own = shared.col(0).segment(begin[b], begin[b + 1] - begin[b]);
    const double square = own.squaredNorm();
    if (square == 0.0) continue;
    auto rows = columns.middleRows(begin[b], own.size());
    const Eigen::RowVectorXd along = own.transpose() * rows;
    rows -= (1.0 - 1.0 / std::sqrt(1.0 + square)) / square * own * along;
  }
}

// Neighbouring rows have the correlation ρ: the innovation of each, with its deviation of 1.
void RecordModel::set_independent(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const {
  const Block& block = blocks_[record];
  const double correlation = pass_.correlation[record];
  Eigen::ArrayXd variance =
      Eigen::ArrayXd::Constant(columns.rows(), pass_.scatter[record] * pass_.scatter[record]);
  if (!pass_.by_path.empty()) variance += pass_.by_path[record].array().square();
  columns.array().colwise() *= (block.count.array() / variance).sqrt();
  if (correlation == 0.0) return;
  const double back = 1.0 / std::sqrt(1.0 - correlation * correlation);
  for (std::size_t g = 0; g + 1 < block.group_begin.size(); ++g) {
    for (Eigen::Index i = block.group_begin[g + 1] - 1; i > block.group_begin[g]; --i) {
      columns.row(i) = back * (columns.row(i) - correlation * columns.row(i - 1));
    }
  }
}

// θ of 1 is a joint of which half the stiffness slips; c of 1 makes as much force as the joint.
void RecordModel::add_blocks() {
  theta_scale_ = 0.5 / basis_.area().sum();
  for (std::size_t r = 0; r < records_->records.size(); ++r) blocks_.push_back(block_of(r));
  if (pass_.viscous) {
    double largest = 0.0;
    for (const Block& block : blocks_) {
      largest = std::max(largest, block.design.rightCols(1).cwiseAbs().maxCoeff());
    }
    viscous_scale_ = largest > 0.0 ? 1.0 / largest : 1.0;
  }
  Eigen::Index rows = 0;
  for (Block& block : blocks_) {
    block.design.leftCols(basis_.size()) *= theta_scale_;
    if (pass_.viscous) block.design.rightCols(1) *= viscous_scale_;
    rows += block.design.rows();
  }
  for (std::size_t t = 0; t < records_->levels.size(); ++t) {
    levels_.push_back(level_block(t));
    levels_.back().first = rows;
    rows += levels_.back().design.rows();
  }
}

void RecordModel::set_problem() {
  Eigen::Index rows = 0;
  for (const Block& block : blocks_) rows += block.design.rows();
  for (const LevelBlock& block : levels_) rows += block.design.rows();
  Eigen::MatrixXd design(rows, columns_);
  Eigen::VectorXd data(rows);
  Eigen::Index at = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Eigen::Index n = blocks_[b].design.rows();
    Eigen::MatrixXd both(n, columns_ + 1);
    both << blocks_[b].design, blocks_[b].data;
    centre(blocks_[b], both);
    whiten(b, both);
    design.middleRows(at, n) = both.leftCols(columns_);
    data.segment(at, n) = both.rightCols(1);
    at += n;
  }
  for (const LevelBlock& block : levels_) {
    const Eigen::Index n = block.design.rows();
    design.middleRows(at, n) = block.weight.asDiagonal() * block.design;
    data.segment(at, n) = block.weight.cwiseProduct(block.data);
    at += n;
  }
  Eigen::MatrixXd penalty = Eigen::MatrixXd::Zero(basis_.size() - 2, columns_);
  penalty.leftCols(basis_.size()) = basis_.second_differences();
  const Eigen::VectorXd budget =
      records_->stiffness_known ? area_row() : Eigen::VectorXd::Zero(columns_);
  problem_.emplace(std::move(design), std::move(data), std::move(penalty), budget,
                   2 + columns_ - basis_.size());
}

RecordModel::RecordModel(const ScaledRecords& records, const RecordPass& pass)
    : records_(&records),
      pass_(pass),
      basis_(records.basis(pass.exponent)),
      columns_(basis_.size() + (records.stiffness_known ? 0 : 1) + (pass.viscous ? 1 : 0)) {
  add_blocks();
  set_problem();
}

LevelRows RecordModel::levels_of(std::size_t table, const Eigen::VectorXd& x) const {
  const LevelBlock& block = levels_[table];
  const Eigen::VectorXd found = block.design * x;
  LevelRows rows;
  const std::size_t of_d = records_->levels[table].size();
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    if (static_cast<std::size_t>(i) < of_d) {
      rows.dissipation.push_back(records_->energy() * found(i));
    } else {
      rows.secant_stiffness.push_back(records_->stiffness * (found(i) + secant_given()));
    }
  }
  return rows;
}

Eigen::VectorXd RecordModel::level_residual(std::size_t table, const Eigen::VectorXd& x) const {
  const LevelBlock& block = levels_[table];
  return block.weight.cwiseProduct(block.data - block.design * x);
}

Eigen::MatrixXd RecordModel::density_matrix() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(basis_.nodal().rows(), columns_);
  matrix.leftCols(basis_.size()) = theta_scale_ * basis_.nodal();
  return matrix;
}

Eigen::VectorXd RecordModel::area_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(columns_);
  row.head(basis_.size()) = theta_scale_ * basis_.area();
  return row;
}

Eigen::VectorXd RecordModel::elastic_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(columns_);
  if (!records_->stiffness_known) row(basis_.size()) = 1.0;
  return row;
}

Eigen::VectorXd RecordModel::viscous_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(columns_);
  if (pass_.viscous) row(row.size() - 1) = viscous_scale_;
  return row;
}

void RecordModel::weight(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const {
  centre(blocks_[record], columns);
  whiten(record, columns);
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

// Of the chord to the row before and to the one behind on the same stretch, the steeper: what
// slips first behind a turn does within a row.
Eigen::VectorXd RecordModel::slope(std::size_t record, const Eigen::VectorXd& x) const {
  const std::vector<PathRow>& rows = records_->records[record].rows().rows;
  const Eigen::VectorXd force = found(record, x);
  Eigen::VectorXd slopes = Eigen::VectorXd::Zero(force.size());
  for (Eigen::Index i = 0; i + 1 < force.size(); ++i) {
    const PathRow& one = rows[static_cast<std::size_t>(i)];
    const PathRow& next = rows[static_cast<std::size_t>(i) + 1];
    const double step = (next.displacement - one.displacement) / records_->length;
    if (next.turns != one.turns || step == 0.0) continue;
    const double chord = std::max(0.0, (force(i + 1) - force(i)) / step);
    slopes(i) = std::max(slopes(i), chord);
    slopes(i + 1) = std::max(slopes(i + 1), chord);
  }
  return slopes;
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
