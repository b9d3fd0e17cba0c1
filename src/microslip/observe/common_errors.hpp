// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/base/random.hpp"

namespace microslip {

/// One draw of the errors that all levels share.
struct CommonErrorDraw {
  double dissipation_gain = 1.0;  ///< e: the true D is e times the measured one, 1
  double amplitude_gain = 1.0;    ///< c: the true A is c times the measured one, 1
  /// δ: the loss assumed of the structure is δ of itself too large, 1.
  double loss_factor = 0.0;
};

/// Standard deviations of the errors that all levels share, relative, from 0 to 0.3. Repeating the
/// test with the same sensors does not reveal them. 0 for none.
struct CommonErrors {
  double dissipation_gain_std = 0.0;  ///< of D: force and velocity sensors together, 1
  double amplitude_gain_std = 0.0;    ///< of A: the displacement sensor, 1

  /// Standard deviation of the loss factor of the structure, 1: where it is a share δ too large, D
  /// of all levels is too low by δW_lin. Above 0 it needs Levels::linear_dissipation.
  double loss_factor_std = 0.0;

  /// @throws InputError  naming the deviation that breaks its rule.
  void check() const;

  /// Takes three normal numbers from the stream. Gains are limited to possible ones: e ≥ 0, c ≥
  /// 0.1.
  [[nodiscard]] CommonErrorDraw draw(RandomStream& random) const;
};

}  // namespace microslip
