// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/base/random.hpp"

namespace microslip {

/// One draw of the errors that all levels share.
struct CommonErrorDraw {
  double dissipation_gain = 1.0;  ///< e: the true D is e times the measured one, 1
  double amplitude_gain = 1.0;    ///< c: the true A is c times the measured one, 1
  double loss_factor = 0.0;       ///< δ: the structure's loss was taken δ of itself too large, 1
};

/// Standard deviations of the errors that all levels share, relative, from 0 to 0.3. Repeating the
/// test with the same sensors does not show them. 0 where they are not in question.
struct CommonErrors {
  double dissipation_gain_std = 0.0;  ///< of D: force and velocity sensors together, 1
  double amplitude_gain_std = 0.0;    ///< of A: the displacement sensor, 1

  /// Of the loss factor of the structure, 1: with a share δ too much of it, all levels have δW_lin
  /// too little D. Above 0 it needs Levels::linear_dissipation.
  double loss_factor_std = 0.0;

  /// @throws InputError  naming the deviation that breaks its rule.
  void check() const;

  /// Takes three normal numbers of the stream. Gains stay possible: e ≥ 0, c ≥ 0.1.
  [[nodiscard]] CommonErrorDraw draw(RandomStream& random) const;
};

}  // namespace microslip
