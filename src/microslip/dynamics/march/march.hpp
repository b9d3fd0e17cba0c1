// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/dynamics/march/load_history.hpp"
#include "microslip/dynamics/march/march_energy.hpp"
#include "microslip/dynamics/march/march_options.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// The motion of a point, one value per recorded time.
struct PointMotion {
  std::string point;                 ///< its name in the modal model
  std::vector<double> displacement;  ///< m
  std::vector<double> velocity;      ///< m/s
  std::vector<double> acceleration;  ///< m/s²
};

/// The motion of a joint, one value per recorded time.
struct JointMotion {
  std::string joint;                 ///< its name in the structure
  std::vector<double> displacement;  ///< u, m: between the ends of the joint itself
  std::vector<double> force;         ///< F, N: the restoring force
};

/// Recorded values at one time, valid until the call returns.
struct MarchRow {
  std::size_t index;                           ///< of the time in the axis
  double time;                                 ///< s
  std::span<const double> displacement;        ///< m; one per point of the options
  std::span<const double> velocity;            ///< m/s; the same
  std::span<const double> acceleration;        ///< m/s²; the same
  std::span<const double> joint_displacement;  ///< u, m; one per joint of the structure
  std::span<const double> joint_force;         ///< F, N; the same
  /// Displacement, velocity and acceleration including the motion of bases, from rest at the first
  /// time; empty where no base accelerates.
  std::span<const double> absolute_displacement = {};
  std::span<const double> absolute_velocity = {};      ///< m/s; or empty
  std::span<const double> absolute_acceleration = {};  ///< m/s²; or empty
};

/// Receives the rows in turn.
using MarchSink = std::function<void(const MarchRow&)>;

/// The largest values of the motion of a point.
struct LargestMotion {
  double displacement = 0.0;  ///< max |w|, m
  double velocity = 0.0;      ///< max |ẇ|, m/s
  double acceleration = 0.0;  ///< max |ẅ|, m/s²
};

/// How large a signal of a march was.
struct SignalSize {
  double peak = 0.0;  ///< max |x|
  double rms = 0.0;   ///< √(∫ x² dt/T), x² straight between two steps
};

/// Up to where the march got. Where it stopped early the records end at the last recorded time that
/// was reached.
struct MarchResult {
  std::vector<double> time;         ///< recorded times, s
  std::vector<PointMotion> points;  ///< in the order of the options
  std::vector<JointMotion> joints;  ///< in the order of the structure
  double reached = 0.0;             ///< the last time of the axis that was reached, s
  /// At the ends of all steps up to there, recorded or not; in the order of the options.
  std::vector<LargestMotion> largest;
  std::vector<double> reach;  ///< max |u| of each joint, m
  /// Sizes of all signals: w, ẇ, ẅ of each point of the options, then u and F of each joint of the
  /// structure, then, where a base accelerates, the absolute w, ẇ, ẅ of each point.
  std::vector<SignalSize> sizes;
  /// Sizes of the absolute motions, three per point; none where no base accelerates.
  [[nodiscard]] std::span<const SignalSize> absolute_sizes() const {
    return std::span(sizes).subspan(std::min(sizes.size(), 3 * largest.size() + 2 * reach.size()));
  }
  MarchEnergy energy;         ///< up to the last time that was reached
  std::size_t steps = 0;      ///< taken, those cut at reversals twice
  std::size_t reversals = 0;  ///< of all joints
  std::size_t kinks = 0;      ///< loops that closed and atoms that began to slip
  /// The largest error of the displacement of a recorded point (of u of a joint where there is
  /// none) at every second step, over its largest value, about the rest under static loads, 1: the
  /// difference from the march with twice the step, over its ratio to the error by the order of the
  /// scheme. 0 for a linear structure; none where it was not requested, or that march failed.
  std::optional<double> error_estimate;
  /// Warnings: `hysteretic_as_viscous`, `damping_as_viscous`, `error_not_estimated`.
  std::vector<Warning> warnings;
  /// Converged: to the last time, with an energy imbalance, its residual, and an estimated error in
  /// bounds. `iterations` counts evaluations of the joints.
  Summary summary;
};

/// Marches a structure in time under any forces, with the exact memory of its joints (Memory) as
/// state:
///
///     q̈_i + η_i ω_i q̇_i + ω_i² q_i = p_i(t),
///     p_i = Σ_d φ_i(d) f_d + Σ_j [k_s,j ψ_ij Σ_r ψ_rj q_r − (ψ_ij − Σ_r Γ_ir q_r) F_j(u_j)]
///
/// Scheme: an exponential integrator [Hochbruck & Ostermann, Acta Numerica 19 (2010) 209]. Each
/// mode goes over a step by the Duhamel integral of its load [Chopra, Dynamics of Structures, ch.
/// 4–5],
///
///     q_i(h) = free vibration + ∫₀ʰ g_i(h − t) p_i(t) dt,   g_i the impulse response,
///
/// in closed form, with p_i the cubic of its values and slopes at both ends, and its excess over
/// that in the middle by the joint forces there; ṗ follows from the tangent stiffness of the
/// joints, u̇ and q̇. A linear structure is exact whatever the step. The joint forces at the end of
/// the step are found by Newton's method. Where u of a joint turns, closes a loop or comes to where
/// an atom begins to slip, found on a quartic of u over the step, its force is a piecewise cubic;
/// steps that are too long for that are cut there. A step whose equations do not converge is
/// halved, again and again down to a millionth.
///
/// The order is 4 where the density is smooth between its atoms, 3 where it jumps inside of a step.
/// A density of more than 16 atoms, and a joint of varying normal load, are of order 2. Stable for
/// h below 3 over the highest frequency of the stuck structure as far as that frequency comes from
/// joints and not from modes; an unstable march shows in its energy.
///
/// On the reference rig, 7 modes, 8 N at 55 Hz, the largest error of w over its largest value is
/// 8.6e-8 with 149 steps per period and 3.3e-10 with 596; docs/validation.md compares it with other
/// schemes.
///
/// A structure with hysteretic damping is marched with the viscous damping of the same η_i, which
/// is the same at each natural frequency: the hysteretic law has no time-domain form. So is the
/// linear damping β of a joint: a viscous damper beside F, c = β/(πω), with the lowest ω of the
/// stuck structure at which the joint moves; there it loses βA² per cycle. With a compliance in
/// series it is correct to first order in (series compliance)·β/π. `force` of the joint is F alone.
///
/// @throws InputError  naming what breaks a rule: a time that does not rise, a force or load that
///                     is not finite, a wrong length, an unknown point or joint, an option.
/// @throws Cancelled   where `progress`, called with the times of the axis, returns false.
[[nodiscard]] MarchResult march(const JointedStructure& structure, const LoadHistory& loads,
                                const MarchOptions& options = {}, const Progress& progress = {});

/// As march(), with each row passed on as it comes: memory does not grow with their number. `time`,
/// `points` and `joints` of the result stay empty.
/// @param structure  that is marched.
/// @param loads      its load history.
/// @param options    as of march().
/// @param sink       called with each row in turn; an exception of it ends the march.
/// @param progress   called with the times of the axis.
/// @throws InputError, Cancelled  as march().
[[nodiscard]] MarchResult march_rows(const JointedStructure& structure, const LoadHistory& loads,
                                     const MarchOptions& options, const MarchSink& sink,
                                     const Progress& progress = {});

}  // namespace microslip
