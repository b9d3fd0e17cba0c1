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
#include "microslip/dynamics/jointed_structure.hpp"
#include "microslip/joint/jenkins_network.hpp"

namespace microslip {

/// The force at a point, or the acceleration of a base, over time.
struct PointForce {
  std::string point;          ///< of the modal model, or a base of it; no two the same
  std::vector<double> force;  ///< N, m/s² of a base; one a time
};

/// The normal load of a joint over time, p(t) = P_N(t)/P_0 [AR14 App. B].
struct JointNormalLoad {
  std::string joint;                                ///< of the structure; no two the same
  std::vector<double> load;                         ///< p, 1; ≥ 0; one a time
  NormalLoadLaw law = NormalLoadLaw::kIncremental;  ///< how its elements answer the load
};

/// What acts on a structure; linear in time between the given times. The excitations of the
/// structure itself, which are periodic, do not act; its static loads do.
struct LoadHistory {
  std::vector<double> time;                        ///< s; at least 2, rising, even or not
  std::vector<PointForce> forces;                  ///< may be none: free vibration
  std::vector<JointNormalLoad> normal_loads = {};  ///< joints that are not named keep p = 1
};

/// The state at the first time; empty vectors are zeros, or, where there are static loads, the
/// equilibrium under them. The joints are virgin but for the way to there.
struct InitialState {
  std::vector<double> displacement = {};  ///< q_i, kg^½ m; one a mode; none with static loads
  std::vector<double> velocity = {};      ///< q̇_i, kg^½ m/s
};

/// How march() integrates, and what it records.
struct MarchOptions {
  /// Longest step, s; ≥ 0, and at least 1e-10 of the time axis. Each interval of the time axis is
  /// cut into the least number of equal steps that are not longer, an even one where the error is
  /// estimated. 0: a twentieth of the shortest period of the stuck structure, an eightieth where a
  /// density has more than 16 atoms, a four-hundredth where a normal load varies.
  double step = 0.0;
  /// Every n-th time of the axis is recorded, from the first on, and the last; ≥ 1.
  std::size_t every = 1;
  /// Points of the modal model whose motion is recorded; no two the same.
  std::vector<std::string> points = {};
  InitialState start = {};  ///< where it begins
  /// What the implicit equations of a step may leave, over the largest joint force so far, 1; from
  /// 1e-14 to 1e-4.
  double tolerance = 1e-8;
  /// Evaluations of the joints that one step may take; ≥ 2.
  int max_iterations = 50;
  /// The energy imbalance above which the march does not count as converged, 1; > 0.
  double largest_imbalance = 1e-4;
  /// Whether the error is estimated: each interval of the time axis is then cut into an even number
  /// of steps, and marched beside it with half as many, for half the time again. Linear structures
  /// are exact, and need none.
  bool estimate_error = true;
  /// The estimated error above which the march does not count as converged, 1; > 0.
  double largest_error = 1e-2;
  /// Jenkins elements that stand for a joint whose normal load varies; ≥ 1, and more than its
  /// density has atoms.
  std::size_t elements = 1000;
};

/// The motion of a point, one value a recorded time.
struct PointMotion {
  std::string point;                 ///< its name in the modal model
  std::vector<double> displacement;  ///< m
  std::vector<double> velocity;      ///< m/s
  std::vector<double> acceleration;  ///< m/s²
};

/// The motion of a joint, one value a recorded time.
struct JointMotion {
  std::string joint;                 ///< its name in the structure
  std::vector<double> displacement;  ///< u, m: between the ends of the joint itself
  std::vector<double> force;         ///< F, N: the restoring force
};

/// What became of the energy in one joint, J.
struct JointEnergy {
  std::string joint;  ///< its name in the structure
  /// Σ ∫ f_i d|z_i| of the sliders, by the closed form on each branch (Memory::dissipation).
  double dissipation = 0.0;
  /// Σ ½κ_i(x − z_i)² of the springs at the end (Memory::stored_energy), and ½cF² of what is in
  /// series.
  double stored = 0.0;
  /// Of the damper beside F that stands for the linear damping of the joint, ∫ c u̇² dt by
  /// quadrature.
  double linear_dissipation = 0.0;
};

/// Where the energy went, J, from the first time to the last that was reached:
///
///     initial + input = kinetic + elastic + linear dissipation
///                       + Σ_joints (stored + dissipation + its own linear dissipation)
///
/// Each by itself, never as the rest of the others: the work of the forces ∫ f ẇ dt and Σ η_i ω_i ∫
/// q̇_i² dt by quadrature, with velocities inside of the steps or, where steps are cut, of fourth
/// order over the states at the ends of the pieces; the joints from the displacements at which they
/// turned. So the imbalance measures the error of the integration.
///
/// For a joint whose normal load varies stored and lost energy cannot be told apart from the work
/// of the load; its `dissipation` then holds ∫ F du, `stored` ½cF² alone.
struct MarchEnergy {
  double initial = 0.0;             ///< of the initial state
  double at_rest = 0.0;             ///< what of it the static loads hold, where there are any
  double input = 0.0;               ///< ∫ Σ f ẇ dt
  double linear_dissipation = 0.0;  ///< Σ_i η_i ω_i ∫ q̇_i² dt
  double kinetic = 0.0;             ///< ½ Σ q̇_i², at the end
  double elastic = 0.0;  ///< ½ Σ ω_i² q_i² − ½ Σ_j k_s,j (ψ_j·q)², at the end
  std::vector<JointEnergy> joints;  ///< in the order of the structure

  /// Of all joints.
  [[nodiscard]] double joint_dissipation() const;
  /// Of all joints.
  [[nodiscard]] double joint_stored() const;
  /// Of all joints.
  [[nodiscard]] double joint_linear_dissipation() const;

  /// Less than this of the rest under static loads is no motion, but rounding.
  static constexpr double kLeastOfRest = 1e-6;

  /// |left − right|/max(|left|, |right|) of the balance, without the energy at rest (of which 1e-6
  /// count), 1; 0 where nothing moves.
  [[nodiscard]] double imbalance() const;
};

/// What is recorded at one time. The values hold until the call returns.
struct MarchRow {
  std::size_t index;                           ///< of the time in the axis
  double time;                                 ///< s
  std::span<const double> displacement;        ///< m; one a point of the options
  std::span<const double> velocity;            ///< m/s; the same
  std::span<const double> acceleration;        ///< m/s²; the same
  std::span<const double> joint_displacement;  ///< u, m; one a joint of the structure
  std::span<const double> joint_force;         ///< F, N; the same
  /// The first three with what bases carry the points along with, from rest at the first time on;
  /// empty where no base accelerates.
  std::span<const double> absolute_displacement = {};
  std::span<const double> absolute_velocity = {};      ///< m/s; likewise
  std::span<const double> absolute_acceleration = {};  ///< m/s²; likewise
};

/// Takes the rows as they come.
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
  std::vector<double> reach;  ///< likewise max |u| of each joint, m
  /// Likewise of all signals: w, ẇ, ẅ of each point of the options, then u and F of each joint of
  /// the structure, then, where a base accelerates, the absolute w, ẇ, ẅ of each point.
  std::vector<SignalSize> sizes;
  /// Those of the absolute motions, three a point; none where no base accelerates.
  [[nodiscard]] std::span<const SignalSize> absolute_sizes() const {
    return std::span(sizes).subspan(std::min(sizes.size(), 3 * largest.size() + 2 * reach.size()));
  }
  MarchEnergy energy;         ///< up to the last time that was reached
  std::size_t steps = 0;      ///< taken, those cut at reversals twice
  std::size_t reversals = 0;  ///< of all joints
  std::size_t kinks = 0;      ///< loops that closed and atoms that began to slip
  /// The largest error of the displacement of a recorded point (of u of a joint where there is
  /// none) at every second step, over its largest value, about the rest under static loads, 1: the
  /// difference from the march with twice the step, over what it is of the error by the order of
  /// the scheme. 0 for a linear structure; none where it was not asked for, or that march failed.
  std::optional<double> error_estimate;
  /// What a user of the result must know: `hysteretic_as_viscous`, `damping_as_viscous`,
  /// `error_not_estimated`.
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
/// in closed form, with p_i the cubic of its values and slopes at both ends, and what it is more
/// than that in the middle by the joint forces there; ṗ follows from the tangent stiffness of the
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
/// 8.6e-8 with 149 steps a period and 3.3e-10 with 596; docs/validation.md compares it with other
/// schemes.
///
/// A structure with hysteretic damping is marched with the viscous damping of the same η_i, which
/// is the same at each natural frequency: the hysteretic law has no form in time. So is the linear
/// damping β of a joint: a viscous damper beside F, c = β/(πω), with the lowest ω of the stuck
/// structure at which the joint moves; there it loses βA² a cycle. With something in series it is
/// right to the first order in (series compliance)·β/π. `force` of the joint is F alone.
///
/// @throws InputError  naming what breaks a rule: a time that does not rise, a force or load that
///                     is not finite, a wrong length, an unknown point or joint, an option.
/// @throws Cancelled   where `progress`, told of the times of the axis, returns false.
[[nodiscard]] MarchResult march(const JointedStructure& structure, const LoadHistory& loads,
                                const MarchOptions& options = {}, const Progress& progress = {});

/// The same with each row given away as it comes: memory does not grow with their number. `time`,
/// `points` and `joints` of the result stay empty.
/// @param structure  that is marched.
/// @param loads      what acts on it.
/// @param options    as of march().
/// @param sink       told of each row in turn; what it throws ends the march.
/// @param progress   told of the times of the axis.
/// @throws InputError, Cancelled  as march().
[[nodiscard]] MarchResult march_rows(const JointedStructure& structure, const LoadHistory& loads,
                                     const MarchOptions& options, const MarchSink& sink,
                                     const Progress& progress = {});

}  // namespace microslip
