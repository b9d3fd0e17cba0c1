// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/harmonic/balance_equations.hpp"
#include "microslip/dynamics/harmonic/newton.hpp"

namespace microslip {

/// Solutions from one level of the force or the response to the next, one target kept. Internal to
/// dynamics.
class AmplitudeContinuation {
 public:
  /// @param level  the force amplitude or the response.
  AmplitudeContinuation(BalanceEquations& equations, const NewtonOptions& options,
                        const Target& kept, Quantity level);

  /// The first solution, at a level so low that the joints hardly slip, but none above `most`: from
  /// the linear vibration with stuck joints at ω.
  NewtonResult start(double angular_frequency, double most);
  /// The first solution from z, near it.
  NewtonResult start_at(double level, const Eigen::VectorXd& z);

  /// Goes to a level in as few steps as converge, each extrapolated from the two before; in the end
  /// exactly there, or, not converged, where it got stuck.
  NewtonResult go_to(double level);

  [[nodiscard]] double level() const { return level_; }
  [[nodiscard]] const Eigen::VectorXd& z() const { return z_; }
  [[nodiscard]] const Eigen::VectorXd& previous() const { return previous_; }

 private:
  [[nodiscard]] Eigen::VectorXd predicted(double level) const;

  BalanceEquations& equations_;
  NewtonOptions options_;
  Target kept_;
  Quantity quantity_;
  double level_ = 0.0;
  double previous_level_ = 0.0;  // 0: none
  Eigen::VectorXd z_;
  Eigen::VectorXd previous_;
};

/// The vibration at ω and A = 1 N with all joints stuck: the linear solution. The joints get a
/// little damping, for a resonance with the correct phase where the structure has none.
[[nodiscard]] Eigen::VectorXd stuck_vibration(BalanceEquations& equations,
                                              double angular_frequency);

/// A linear solution at another level. A joint that moves by the shortening alone, which a linear
/// vibration lacks, gets that displacement.
[[nodiscard]] Eigen::VectorXd scaled(BalanceEquations& equations, Eigen::VectorXd z,
                                     const Target& level);

}  // namespace microslip
