// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/records/record_settling.hpp"

/// @file
/// What drifting zeros of sensors do to the force of the rows of a record. Internal: Eigen stays
/// out of the installed headers.

namespace microslip {

/// Means of the samples of each row. @param values  one per sample of the record.
[[nodiscard]] Eigen::VectorXd means_of_rows(const std::vector<PathRow>& rows,
                                            const std::vector<double>& values);

/// Change of the force of each row with each coefficient of SensorDrift::force, both over k₀X: the
/// mean of τ^p, p = 1 to `terms`.
[[nodiscard]] Eigen::MatrixXd force_drift_rows(const SettledRecords& settled, std::size_t record,
                                               Eigen::Index terms);

/// Change of the force of each row, over k₀X, with each coefficient of SensorDrift::displacement,
/// over X: the force of the joint along the path u − sτ^p X less that along u, over s. The joint
/// answers to the motion within each branch and to where sliders that do not slip are, so that this
/// is not the same as a drift of the force.
/// @param size  s: a small part of the range that is about the drift.
[[nodiscard]] Eigen::MatrixXd displacement_drift_rows(const SettledRecords& settled,
                                                      std::size_t record, Eigen::Index terms,
                                                      double size);

}  // namespace microslip
