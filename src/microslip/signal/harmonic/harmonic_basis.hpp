// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/algebra/core.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// The points of a record: τ = t − middle, and s = τ/half_width, −1 at the first and 1 at the last.
/// Internal to signal.
class RecordTimes {
 public:
  /// @param points  2 at least. The axis must outlive this.
  RecordTimes(const Axis& axis, std::size_t points);

  [[nodiscard]] Eigen::Index points() const { return points_; }
  [[nodiscard]] bool even() const { return axis_.even(); }
  [[nodiscard]] double middle() const { return middle_; }          ///< s
  [[nodiscard]] double half_width() const { return half_width_; }  ///< s
  /// Mean distance of the points, s.
  [[nodiscard]] double step() const { return 2.0 * half_width_ / static_cast<double>(points_ - 1); }
  /// Duration that the record represents: one step per point, s.
  [[nodiscard]] double length() const { return step() * static_cast<double>(points_); }
  /// s of point i, 1.
  [[nodiscard]] double s(Eigen::Index i) const;

 private:
  const Axis& axis_;
  Eigen::Index points_;
  double middle_;
  double half_width_;
};

/// Points [first, last) of a record.
struct PointRange {
  Eigen::Index first;
  Eigen::Index last;

  [[nodiscard]] Eigen::Index size() const { return last - first; }
};

/// Sums over a record with z_k = e^{−ikΩs}, k = 1 … K, Ω = ω·half_width. Internal to signal.
///
/// For even steps the z of a piece of 128 points are those of one table times the z of its first
/// point: e^{−ikΩ(s₀ + l Δs)}. So no sine is computed a point and no recurrence loses accuracy, and
/// the sums of z alone over a piece are the same for each.
class HarmonicBasis {
 public:
  /// @param times  must outlive this. @param order  K ≥ 1.
  HarmonicBasis(const RecordTimes& times, double big_omega, Eigen::Index order);

  /// Σ_i d_i z_k(i) over the range, k = 1 … order ≤ K, for each column d: order × columns.
  [[nodiscard]] Eigen::MatrixXcd sums(const Eigen::MatrixXd& columns, PointRange range,
                                      Eigen::Index order) const;

  /// Σ_i s_i^q z_k(i) over the range: (degree + 1) × (K + 1), with k = 0 in the first column.
  [[nodiscard]] Eigen::MatrixXcd moments(Eigen::Index degree, PointRange range) const;

  /// Takes Σ_k Re(c_k conj(z_k)) from each column. @param c  order × columns.
  void subtract_series(const Eigen::MatrixXcd& c, Eigen::MatrixXd& columns) const;

 private:
  /// Pairs of z_1 … z_order at the points of a piece, less the z of its first.
  [[nodiscard]] Eigen::MatrixXd uneven_piece(PointRange range, Eigen::Index order) const;
  /// z_1 … z_order at one point.
  [[nodiscard]] Eigen::VectorXcd start(Eigen::Index first, Eigen::Index order) const;

  const RecordTimes& times_;
  double big_omega_;
  Eigen::Index order_;
  Eigen::MatrixXd table_;  ///< even steps: points of a piece × 2K: Re z_1, Im z_1, Re z_2, …
};

}  // namespace microslip
