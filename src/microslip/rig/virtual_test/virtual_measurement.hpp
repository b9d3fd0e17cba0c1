// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/virtual_test/driven_vibration.hpp"

/// @file
/// A frictional-support test on a rig whose joint is known: stepped sine over levels of the
/// response.

namespace microslip {

/// Warnings of a level.
inline constexpr std::string_view kMacroSlip = "macro_slip";
/// The control did not reduce the harmonics of the force.
inline constexpr std::string_view kForceNotControlled = "force_not_controlled";
/// H could not be measured.
inline constexpr std::string_view kTransferNotMeasured = "transfer_not_measured";

/// One level of the test.
struct VirtualLevel {
  std::size_t number = 0;            ///< from 1
  double response = 0.0;             ///< |A_1| at the exciter, controlled, m/s²
  double resonance_frequency = 0.0;  ///< of phase resonance at this level under a pure force, Hz
  double frequency = 0.0;            ///< of the drive: rounded to its resolution, Hz
  /// As recorded. Its `vibration` is the truth: amplitude and dissipation of the joint, energies.
  DrivenVibration controlled;
  /// At the same response under a sinusoidal voltage; without harmonics where there is no shaker.
  DrivenVibration uncontrolled;
  int control_iterations = 0;  ///< changes of the voltage harmonics
  /// Converged where the vibrations are; what the force control did not reach is a warning.
  Summary summary;
  std::vector<Warning> warnings;  ///< of this level, see measure_virtually()
};

/// Result of measure_virtually().
struct VirtualMeasurement {
  std::vector<VirtualLevel> levels;  ///< all, in order
  /// Converged where all levels are. Iterations are balances solved, the residual is the largest.
  Summary summary;
};

/// How measure_virtually() controls the force.
struct VirtualMeasurementOptions {
  /// false: the force is a pure sine, and no shaker needs control.
  bool shaker = true;
  std::size_t controlled_harmonics = 10;  ///< N; 2 or more
  /// |F_n|/|F_1|, n = 2 … N, at which the control stops, 1; above 0. The paper requires 0.01.
  double force_distortion = 0.003;
  int max_control_iterations = 30;  ///< 0 or more
  std::size_t samples = 256;        ///< see HarmonicBalanceOptions
  double linear_damping = 0.0;      ///< β of the joint, J/m²: see StructuralJoint; 0 or more
  Progress progress = {};           ///< levels done of all levels
  Execution execution = Execution::threads();  ///< of the levels
};

/// The responses of the test, m/s²: equally spaced or in equal ratios; of one level the lower end.
[[nodiscard]] std::vector<double> response_levels(const RigTest& test);

/// Runs the test of a rig with this joint in its contact.
///
/// Each level has its own resonance: the frequency of phase resonance at this response under a pure
/// force, on the backbone. The drive is set to it, to `frequency_resolution`, and the response is
/// controlled: V_1 is always that required by the response, as for an amplitude controller in its
/// steady state. A sinusoidal voltage makes the uncontrolled state. Then the harmonics V_2 … V_N of
/// the voltage are changed until those of the force are down, by
///
///     V ← V − H⁻¹F,
///
/// where the controller only measures the harmonics of the force: H is measured once, by small
/// voltages in all harmonics at the lowest level, and corrected after each step [Broyden, Math.
/// Comp. 19 (1965) 577]. It measures them without noise, as after long averaging.
///
/// Every state that is returned satisfies the equations of structure, joint and shaker together:
/// the harmonic balance (HarmonicBalance) under the harmonics F_n, and F_n = a_n V_n − b_n w_n
/// (shaker.hpp). It keeps max(test.harmonics, N) harmonics, or test.harmonics without a shaker.
/// Levels are solved in parallel; the result does not depend on the number of threads.
///
/// A level whose vibration is not found has a summary with the reason; the others are computed.
/// Warnings: `macro_slip`, all of the joint has slipped, so that no higher level determines more of
/// its density; `force_not_controlled`; `transfer_not_measured`, at the level where H was to be
/// measured: it is then that of the linear structure.
/// @throws InputError  as stick_state(); where there is no test, an option is out of range, no
///                     mode moves the exciter, the sampling of the test cannot show the harmonics
///                     of a drive or three cycles, or the resolution of the drive is above 1 % of
///                     the stuck resonance.
/// @throws Cancelled   as progress says.
[[nodiscard]] VirtualMeasurement measure_virtually(const Rig& rig, const Joint& joint,
                                                   const VirtualMeasurementOptions& options = {});

}  // namespace microslip
