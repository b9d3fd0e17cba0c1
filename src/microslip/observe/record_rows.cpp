// SPDX-License-Identifier: MIT
#include "microslip/observe/record_rows.hpp"

#include <algorithm>
#include <cstddef>

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

/// p at a scaled slip displacement, from p at the knots, times a factor.
void add_density(double s, double factor, const std::vector<double>& knots,
                 Eigen::Ref<Eigen::RowVectorXd> row) {
  if (s >= knots.back()) return;
  if (s <= knots.front()) {
    row(0) += factor;
    return;
  }
  const auto above = std::ranges::upper_bound(knots, s);
  const auto j = above - knots.begin();
  const double share = (s - *(above - 1)) / (*above - *(above - 1));
  row(j - 1) += factor * (1.0 - share);
  row(j) += factor * share;
}

void add_virgin(double h, double factor, const std::vector<double>& knots,
                Eigen::Ref<Eigen::RowVectorXd> row) {
  const double first = knots.front();
  const double slipped = std::min(h, first);
  row(0) += factor * (0.5 * slipped * slipped + h * (first - slipped));
  for (std::size_t j = 0; j + 1 < knots.size(); ++j) {
    const double l = knots[j];
    const double r = knots[j + 1];
    double left = 0.0;
    double right = 0.0;
    const double end = std::clamp(h, l, r);
    const double share = (end - l) / (r - l);
    add_straight(l, end, l, end, 0.0, share, left, right);
    add_straight(end, r, h, h, share, 1.0, left, right);
    row(static_cast<Eigen::Index>(j)) += factor * left;
    row(static_cast<Eigen::Index>(j) + 1) += factor * right;
  }
}

}  // namespace

Eigen::RowVectorXd virgin_row(double h, const std::vector<double>& knots) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(knots.size()));
  add_virgin(h, 1.0, knots, row);
  return row;
}

Eigen::MatrixXd stop_rows(const PathRows& path, double length, const std::vector<double>& knots) {
  const auto columns = static_cast<Eigen::Index>(knots.size());
  Eigen::MatrixXd turns =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(path.turns.size()), columns);
  Eigen::RowVectorXd row(columns);
  for (std::size_t i = 0; i < path.turns.size(); ++i) {
    row.setZero();
    for (const PathStretch& one : path.turns[i]) {
      add_virgin(one.half_range / length, one.coefficient, knots, row);
    }
    turns.row(static_cast<Eigen::Index>(i)) = row;
  }
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(path.rows.size()), columns);
  for (std::size_t i = 0; i < path.rows.size(); ++i) {
    const PathRow& one = path.rows[i];
    row = turns.row(static_cast<Eigen::Index>(one.turns));
    const double h = one.last.half_range / length;
    add_virgin(h, one.last.coefficient, knots, row);
    const double variance = one.variance / (length * length);
    add_density(h, -0.5 * variance * one.last.coefficient, knots, row);
    rows.row(static_cast<Eigen::Index>(i)) = row;
  }
  return rows;
}

}  // namespace microslip
