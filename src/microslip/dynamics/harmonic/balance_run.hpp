// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/algebra/core.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/dynamics/harmonic/balance_equations.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance_options.hpp"
#include "microslip/dynamics/harmonic/newton.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/harmonic/target.hpp"

/// @file
/// Solutions and curves that begin at the structure with all joints stuck. Internal to dynamics.

namespace microslip {

/// ω at which a mode of the structure vibrates while all joints stick, rad/s.
/// @param mode  from 0. @throws InputError  where there is none, or it is a rigid body.
[[nodiscard]] double stuck_frequency(const JointedStructure& structure, std::size_t mode);

/// The equations of one call of HarmonicBalance and how Newton's method solves them.
struct BalanceRun {
  BalanceRun(const JointedStructure& structure, const ResponsePoint& response,
             const HarmonicBalanceOptions& options);

  /// Where Newton's method ended.
  struct Outcome {
    NewtonResult newton;
    Eigen::VectorXd z;
  };

  /// From the linear vibration at ω; if Newton's method fails, through growing levels.
  [[nodiscard]] Outcome from_stuck(const Target& kept, const Target& level,
                                   double angular_frequency);

  /// Up the level at this phase until the frequency is passed.
  /// @param stuck  ω of the mode, rad/s.
  [[nodiscard]] Outcome at_frequency(const Target& phase, const Target& frequency, double stuck);

  /// As HarmonicBalance::solve() without a start.
  /// @throws InputError  where the targets are force and response.
  [[nodiscard]] Outcome solve(Target first, Target second, std::size_t mode);

  BalanceEquations equations;
  NewtonOptions newton_options;
};

/// HarmonicBalance::follow() with all that it is given checked, the time it took left out.
[[nodiscard]] ResponseCurve follow_from_stuck(const JointedStructure& structure,
                                              const ResponsePoint& response,
                                              const HarmonicBalanceOptions& options,
                                              const Target& kept, Quantity along, double from,
                                              double to, std::size_t mode,
                                              const Progress& progress);

}  // namespace microslip
