// SPDX-License-Identifier: MIT
#include "microslip/observe/record_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace microslip {
namespace {

/// Adds ∫ₗʳ of a kernel that is value_l at l and value_r at r, straight between them, times the hat
/// functions of a cell: share_l and share_r are those of its right end.
void add_straight(double l, double r, double value_l, double value_r, double share_l,
                  double share_r, double& left, double& right) {
  const double width = (r - l) / 6.0;
  const double with_right =
      width * (value_l * (2.0 * share_l + share_r) + value_r * (share_l + 2.0 * share_r));
  right += with_right;
  left += 3.0 * width * (value_l + value_r) - with_right;
}

/// Σ factor ∫ min(h, s) p ds of any number of h, from p at the knots. The cell of an h is cut by
/// it; those below are like for all h above, those above are of h alone: sums over cells.
class VirginSum {
 public:
  explicit VirginSum(const std::vector<double>& knots)
      : knots_(knots),
        row_(Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(knots.size()))),
        factor_(knots.size() + 1, 0.0),
        moment_(knots.size() + 1, 0.0) {}

  void add(double h, double factor) {
    const auto cell =
        static_cast<std::size_t>(std::ranges::upper_bound(knots_, h) - knots_.begin());
    factor_[cell] += factor;
    moment_[cell] += factor * h;
    if (cell == 0) {
      row_(0) += factor * h * (knots_.front() - 0.5 * h);
    } else if (cell < knots_.size()) {
      const double l = knots_[cell - 1];
      const double r = knots_[cell];
      const double share = (h - l) / (r - l);
      double left = 0.0;
      double right = 0.0;
      add_straight(l, h, l, h, 0.0, share, left, right);
      add_straight(h, r, h, h, share, 1.0, left, right);
      add_to_cell(cell, factor * left, factor * right);
    }
  }

  /// The sum; the next is empty.
  Eigen::RowVectorXd take() {
    double above = 0.0;
    for (std::size_t cell = knots_.size(); cell > 0; --cell) {
      if (cell < knots_.size()) add_below(cell, above);
      above += factor_[cell];
    }
    row_(0) += 0.5 * above * knots_.front() * knots_.front();
    double below = 0.0;
    for (std::size_t cell = 1; cell < knots_.size(); ++cell) {
      below += moment_[cell - 1];
      const double half = 0.5 * below * (knots_[cell] - knots_[cell - 1]);
      add_to_cell(cell, half, half);
    }
    std::ranges::fill(factor_, 0.0);
    std::ranges::fill(moment_, 0.0);
    return std::exchange(row_, Eigen::RowVectorXd::Zero(row_.size()));
  }

 private:
  void add_to_cell(std::size_t cell, double left, double right) {
    row_(static_cast<Eigen::Index>(cell) - 1) += left;
    row_(static_cast<Eigen::Index>(cell)) += right;
  }

  /// A cell of which all sliders have slipped.
  void add_below(std::size_t cell, double factor) {
    const double l = knots_[cell - 1];
    const double r = knots_[cell];
    double left = 0.0;
    double right = 0.0;
    add_straight(l, r, l, r, 0.0, 1.0, left, right);
    add_to_cell(cell, factor * left, factor * right);
  }

  const std::vector<double>& knots_;
  Eigen::RowVectorXd row_;
  std::vector<double> factor_;  // of the h in each cell: below the first knot, between two, above
  std::vector<double> moment_;  // and times h
};

}  // namespace

Eigen::RowVectorXd virgin_row(double h, const std::vector<double>& knots) {
  VirginSum sum(knots);
  sum.add(h, 1.0);
  return sum.take();
}

Eigen::MatrixXd stop_rows(const PathRows& path, double length, const std::vector<double>& knots) {
  const auto columns = static_cast<Eigen::Index>(knots.size());
  VirginSum sum(knots);
  Eigen::MatrixXd turns(static_cast<Eigen::Index>(path.turns.size()), columns);
  for (std::size_t i = 0; i < path.turns.size(); ++i) {
    for (const PathStretch& one : path.turns[i]) sum.add(one.half_range / length, one.coefficient);
    turns.row(static_cast<Eigen::Index>(i)) = sum.take();
  }
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(path.rows.size()), columns);
  std::size_t sample = 0;
  for (std::size_t i = 0; i < path.rows.size(); ++i) {
    const PathRow& one = path.rows[i];
    const double factor = one.last.coefficient / static_cast<double>(one.count);
    for (std::size_t j = 0; j < one.count; ++j) sum.add(path.half_range[sample++] / length, factor);
    rows.row(static_cast<Eigen::Index>(i)) =
        turns.row(static_cast<Eigen::Index>(one.turns)) + sum.take();
  }
  return rows;
}

}  // namespace microslip
