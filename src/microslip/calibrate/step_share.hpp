// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

/// @file
/// Damping of the steps of the joints. Internal to calibrate.

namespace microslip {

/// Share of each Gauss–Newton step that is taken, in (0, 1]: half of the one before where passes
/// cycle, that is where the change by a whole step, change/share, does not fall by a third in three
/// of them. A map with the eigenvalue μ has the eigenvalue 1 − s(1 − μ) with
/// the share s: for real μ < 1 it is a contraction where s < 2/(1 − μ).
class StepShare {
 public:
  /// @param first  share to begin with.
  explicit StepShare(double first) : share_(first) {}

  [[nodiscard]] double share() const { return share_; }

  /// Takes the change of a pass into account. @param change  relative, with the present share.
  void take(double change);

  /// The change by a whole step.
  [[nodiscard]] double of_whole_step(double change) const { return change / share_; }

 private:
  double share_;
  double reference_ = std::numeric_limits<double>::infinity();
  int stalled_ = 0;
};

}  // namespace microslip
