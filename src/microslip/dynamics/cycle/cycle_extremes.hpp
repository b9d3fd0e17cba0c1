// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"

namespace microslip {

/// The extremes of a trigonometric polynomial over its period, in the order of time: where a joint
/// reverses. Internal to dynamics.
class CycleExtremes {
 public:
  struct Extreme {
    double tau;           ///< angle in the period, rad
    double displacement;  ///< x there, m
    double acceleration;  ///< d²x/dτ² there, m
    Eigen::Index next;    ///< the first sample behind it
  };

  /// An extreme lies beside each sample that is above (below) both of its neighbours, and the sign
  /// of the velocity at the sample gives the side; Newton's method, kept in the interval, finds it.
  /// @param x             the samples, equally spaced over the period; of an odd wave an even
  ///                      number, the second half the negated first.
  /// @param coefficients  as in trigonometric_basis.hpp.
  /// @param wave          of an odd wave the second half of the extremes is the negated first.
  void find(std::span<const double> x, std::span<const double> coefficients, Wave wave);

  /// 0 where all samples are equal; otherwise even, a maximum after each minimum.
  [[nodiscard]] std::size_t size() const { return extremes_.size(); }
  [[nodiscard]] const Extreme& operator[](std::size_t i) const { return extremes_[i]; }

  /// Index of the extreme of the largest |x|.
  [[nodiscard]] std::size_t largest() const;
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double highest() const;

 private:
  void add_opposite(std::size_t samples);

  std::vector<Extreme> extremes_;
};

}  // namespace microslip
