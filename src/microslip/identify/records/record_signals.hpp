// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/records/departure_fit.hpp"
#include "microslip/identify/records/record_settling.hpp"

/// @file
/// The rows of a record as departures from a joint see them. Internal: Eigen stays out of the
/// installed headers.

namespace microslip {

/// Signals of the rows of a record, and what follows from its samples. Forces are over k₀X,
/// displacements over X, the others of largest absolute value 1.
class RecordSignals {
 public:
  /// @param settled  the joint; must outlive this. @param record  index of the record.
  RecordSignals(const SettledRecords& settled, std::size_t record);

  Eigen::VectorXd measured;      ///< force less its offset, over the largest
  Eigen::VectorXd found;         ///< force of the joint, over the largest
  Eigen::VectorXd displacement;  ///< from where the joint is without force
  Eigen::VectorXd velocity;
  Eigen::VectorXd direction;  ///< of the motion, ±1
  Eigen::VectorXd time;       ///< from −1 to 1
  Eigen::VectorXd work;       ///< done so far, from −1 to 1
  Eigen::VectorXd slipped;    ///< force of the sliders that have slipped on each stretch, summed

  /// Deviations of branches that still meet the stretch before them, of each row: a branch of half
  /// range h that meets it at half range a deviates by q(h, a), and by what the stretch before it
  /// deviated there times h/a. The virgin curve does not.
  /// @param deviation  q, of h and a over X; 0 at h = 0 and at h = a.
  template <typename Deviation>
  [[nodiscard]] Eigen::VectorXd along_branches(const Deviation& deviation) const;

  /// The virgin curve of the joint at a half range over X.
  [[nodiscard]] double virgin(double half_range) const;

  /// ∫ |z|ⁿ du and ∫ sgn(z u̇) |z|ⁿ du of each row, z the measured force less a spring's, over the
  /// largest: a smooth hysteretic link (Bouc–Wen) has dz = (A − (γ + β sgn(z u̇)) |z|ⁿ) du.
  /// @param exponent  n. @param spring  its stiffness over that of the chord to the largest force.
  [[nodiscard]] Eigen::MatrixXd hysteretic(double exponent, double spring) const;

  /// The path of a joint in series with a play of ± `play`, over X: what moves while the force
  /// passes zero is in the play.
  [[nodiscard]] MovedPath behind_play(double play) const;

  /// The path less a drift of its zero, `size` τ^`power` over X, τ the time from 0 to 1.
  [[nodiscard]] MovedPath without_drift(double size, double power) const;

  /// Change of the force of each row with a drift of the displacement: displacement_drift_rows().
  [[nodiscard]] Eigen::MatrixXd displacement_drift() const;

 private:
  void read_rows();
  void read_samples();
  [[nodiscard]] double saturated(double half_range) const;
  void read_slipped();
  [[nodiscard]] MovedPath moved_to(const std::vector<double>& path) const;
  [[nodiscard]] Eigen::MatrixXd stops_along(const std::vector<double>& path) const;

  const SettledRecords* settled_;
  std::size_t record_;
  double length_;               // X, m
  std::vector<double> knots_;   // of the density, over X
  Eigen::VectorXd density_;     // at them
  std::vector<double> path_;    // of the samples, over X, from the first
  std::vector<double> way_;     // direction of each sample
  std::vector<double> force_;   // of the samples, less the offset, over the largest
  std::vector<double> virgin_;  // at even half ranges
  Eigen::MatrixXd stops_;       // along path_
};

template <typename Deviation>
Eigen::VectorXd RecordSignals::along_branches(const Deviation& deviation) const {
  const PathRows& path = settled_->records->records[record_].rows();
  // Of a stretch that begins where one of half range a ended, which deviated by `before`.
  const auto part = [&](const PathStretch& stretch, double a, double before) {
    if (a <= 0.0) return 0.0;
    const double h = std::min(stretch.half_range / length_, a);
    return 2.0 * deviation(h, a) + before * h / a;
  };
  struct Behind {
    double sum = 0.0;   // of the stretches
    double last = 0.0;  // of the last one
  };
  std::vector<Behind> behind;
  for (const std::vector<PathStretch>& turns : path.turns) {
    Behind all;
    for (std::size_t i = 1; i < turns.size(); ++i) {
      all.last = part(turns[i], turns[i - 1].half_range / length_, all.last);
      all.sum += turns[i].coefficient > 0.0 ? all.last : -all.last;
    }
    behind.push_back(all);
  }
  Eigen::VectorXd sums(static_cast<Eigen::Index>(path.rows.size()));
  for (std::size_t i = 0; i < path.rows.size(); ++i) {
    const PathRow& row = path.rows[i];
    const Behind& all = behind[row.turns];
    const double own =
        path.turns[row.turns].empty()
            ? 0.0
            : part(row.last, path.turns[row.turns].back().half_range / length_, all.last);
    sums(static_cast<Eigen::Index>(i)) = all.sum + (row.last.coefficient > 0.0 ? own : -own);
  }
  return sums;
}

}  // namespace microslip
