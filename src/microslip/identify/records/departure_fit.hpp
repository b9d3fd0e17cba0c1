// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/records/record_settling.hpp"

/// @file
/// How much of the force of a record is left beside a joint and a departure from it. Internal:
/// Eigen stays out of the installed headers.

namespace microslip {

/// The path that a joint follows in place of the measured one, as changes of the rows.
struct MovedPath {
  Eigen::MatrixXd stop;          ///< of the force of each row, from p at the knots: rows × knots
  Eigen::VectorXd displacement;  ///< of each row, over X
};

/// A departure in columns of the rows of a record, over k₀X, of any scale.
struct DepartureColumns {
  Eigen::MatrixXd limited = {};         ///< with coefficients ≥ 0
  Eigen::MatrixXd free = {};            ///< with coefficients of either sign
  std::optional<MovedPath> moved = {};  ///< the path of the joint, where it is another
  double freedom = 0.0;                 ///< of them together, with that of the choice
};

/// The joint of all evidence beside departures of one record, each time fitted anew to the force as
/// it is: rows are weighed alike but for the noise of the path. Whitened by the correlation of what
/// is left, increments would be fitted, and small parts of a wrong departure would explain them.
class DepartureFit {
 public:
  /// @param settled  the joint. @param record  index of the record.
  DepartureFit(const SettledRecords& settled, std::size_t record);

  /// What is left.
  struct Left {
    double share = 0.0;  ///< of the force of the record, rms, 1
    double noise = 0.0;  ///< effect of noise on one coefficient, as such a share
  };
  [[nodiscard]] Left without() const { return left_; }
  [[nodiscard]] Left with(const DepartureColumns& columns) const;

  /// Takes columns among those of the joint.
  void add(const DepartureColumns& columns);

 private:
  /// Weighted columns of the rows of the record, of which the first are the joint's.
  struct Rows {
    Eigen::MatrixXd columns;
    std::vector<bool> limited;  ///< coefficients ≥ 0
    Eigen::VectorXd data;
    Eigen::MatrixXd gram;  ///< of columns and data
  };
  [[nodiscard]] Rows joined(const DepartureColumns& columns) const;
  [[nodiscard]] Rows moved(const MovedPath& path) const;
  [[nodiscard]] Left fit(const Rows& rows) const;
  [[nodiscard]] Eigen::MatrixXd weighted(Eigen::MatrixXd columns) const;

  const ScaledRecords* records_;
  std::size_t record_;
  RecordModel model_;
  Eigen::MatrixXd ridge_;      // of the joint, and of the evidence beside the record
  Eigen::VectorXd linear_;     // of the latter
  double other_square_ = 0.0;  // of its data
  double force_square_ = 0.0;  // of the record, weighted
  Rows rows_;
  Left left_;
};

}  // namespace microslip
