// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "microslip/dynamics/march/joint_path.hpp"
#include "microslip/dynamics/march/march_energy.hpp"
#include "microslip/dynamics/march/march_loops.hpp"
#include "microslip/dynamics/march/march_options.hpp"
#include "microslip/dynamics/march/march_weights.hpp"
#include "microslip/dynamics/march/marched_joint.hpp"
#include "microslip/dynamics/march/step_breakpoints.hpp"
#include "microslip/dynamics/march/step_cubic.hpp"
#include "microslip/dynamics/march/step_quadrature.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// The state of a structure in a march and its path over one step. Internal to dynamics.
///
/// Where joints turn or their tangents jump in a step their forces are piecewise cubics over it
/// (step_breakpoints.hpp). Where that is not possible – joints with shortening, parallel dampers or
/// a varying normal load, modes that a step does not resolve – or does not converge, the step is
/// cut at these places.
class MarchState {
 public:
  /// @param hysteresis  one per joint of the structure.
  /// @param coarseness  ratio of its steps to those of the march whose error it estimates: both
  ///     step over breakpoints, or both are cut, so that their errors are of one order.
  MarchState(const JointedStructure& structure, std::vector<MarchedJoint> hysteresis,
             const MarchOptions& options, double coarseness = 1.0);

  /// Loads: the force on each mode and the normal load of each joint, with their slopes in time.
  struct Loads {
    std::vector<double> force;         ///< one per mode, padded by zeros, N kg^−½
    std::vector<double> slope;         ///< per second
    std::vector<double> normal;        ///< p, one per joint
    std::vector<double> normal_slope;  ///< per second
  };
  /// Initially none and p = 1. Values set here apply from now on, and advance with their slopes.
  [[nodiscard]] Loads& loads() { return loads_; }

  /// Goes to this state under the loads that were set.
  void start(const InitialState& start);

  /// Takes a step of the length of the weights. @return false where its equations did not converge.
  [[nodiscard]] bool step(const StepWeights& weights);

  [[nodiscard]] std::span<const double> displacement() const { return q_; }
  [[nodiscard]] std::span<const double> velocity() const { return v_; }
  /// q̈_i.
  [[nodiscard]] double acceleration(std::size_t mode) const;
  [[nodiscard]] const MarchedJoint& joint(std::size_t j) const { return joints_[j].hysteresis; }

  [[nodiscard]] std::size_t steps() const { return steps_; }
  [[nodiscard]] std::size_t reversals() const { return reversals_; }
  /// Loops that closed, atoms that began to slip and jumps of densities that were passed.
  [[nodiscard]] std::size_t kinks() const { return kinks_; }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }
  /// Relative change of the joint forces in the last step that did not converge.
  [[nodiscard]] double last_change() const { return last_change_; }
  [[nodiscard]] MarchEnergy energy() const;

 private:
  /// A joint at one end of a step.
  struct Kinematics {
    double slide = 0.0;      ///< s = ψ·q, m
    double slide_dot = 0.0;  ///< m/s
    double gap = 0.0;        ///< y = s − ½ q·Γq = u + cF, m
    double gap_dot = 0.0;    ///< m/s
    double gap_ddot = 0.0;   ///< m/s²; at the end of a step known where something is damped
    double force = 0.0;      ///< F and that of the damper, N
    double force_dot = 0.0;  ///< N/s
    double u_dot = 0.0;      ///< u̇ at the damper, m/s
    double u_ddot = 0.0;     ///< m/s²
    double r = 0.0;          ///< R = force − k_s s, N: less the springs in the modes
    double r_dot = 0.0;      ///< N/s
  };
  /// Second derivatives over the last step.
  struct Curvature {
    double force = 0.0;  ///< N/s²
    double r = 0.0;      ///< N/s²
  };
  struct Joint {
    std::vector<double> shape;  ///< ψ, padded
    std::vector<double> gamma;  ///< Γ by padded rows; empty without shortening
    double spring;              ///< k_s, N/m
    double compliance;          ///< c, m/N
    double damper;              ///< parallel to F, N s/m
    MarchedJoint hysteresis;
    JointPath path;                  ///< over the step that is tried
    BreakpointMoments moments = {};  ///< of its breakpoints, if it has any
    double middle =
        0.0;  ///< F in the middle of a step without breakpoints, less the cubic there, N
    Kinematics begin = {};
    Kinematics end = {};
    Curvature curvature = {};
    std::vector<double> g = {};      ///< Γq at the end
    std::vector<double> g_dot = {};  ///< Γq̇
    int direction = 0;               ///< of the motion; 0 before the first
    bool turned_here = false;        ///< at the present place, without a path to it
    double kink = HUGE_VAL;          ///< y at which the tangent jumps next, m
    double tangent = 0.0;            ///< dF/du in the equations of the step, N/m
    double damped = 0.0;             ///< lost in the damper, J
    double largest_force = 0.0;      ///< |F| so far, N
    double largest_gap = 0.0;        ///< |y| so far, m
  };
  /// Σ_i ψ_ij w_i ψ_il for the weights w of the loads at the end, in the middle and of breakpoints:
  /// their effect on the slides. Joints are padded as modes are.
  struct Couplings {
    double length = 0.0;
    bool of_others = true;     ///< those off the diagonal, too
    std::vector<double> ends;  ///< [joint][march_loops::CouplingKind][joint]
    double breakpoint_length = 0.0;
    std::vector<double> breakpoints;  ///< [joint][kBreakpointTerms][BreakpointWeights::Kind][joint]
  };
  /// Motion over a step below this share of the largest is rounding.
  static constexpr double kQuiet = 1e-13;
  /// The first event in a step: a joint turns, or its tangent jumps.
  struct Change {
    double share = 1.0;     ///< of the step; 1 without a change, 0 where it is passed already
    std::size_t joint = 0;  ///< of which
    bool turns = false;     ///< otherwise it reaches a kink
  };
  /// In the step, after the length. Rounding makes no load that falls to 0 a negative one.
  [[nodiscard]] double normal_load(std::size_t j, double length) const {
    return std::max(0.0, loads_.normal[j] + length * loads_.normal_slope[j]);
  }
  /// The coupling of a joint with itself.
  [[nodiscard]] double own_coupling(const Couplings& couplings, march_loops::CouplingKind kind,
                                    std::size_t j) const {
    const std::size_t lanes = joint_groups_ * kLanes;
    return couplings.ends[(j * march_loops::kCouplings + kind) * lanes + j];
  }
  [[nodiscard]] std::span<const double> moments_of(const Joint& joint) const {
    return std::span(joint.moments).first(breakpoint_weights_.terms());
  }
  void add_joint(const StructuralJoint& joint, double damper, MarchedJoint hysteresis);
  [[nodiscard]] double longest_step_over_breakpoints(bool beside_longer) const;
  void begin(std::size_t j);
  void begin_dampers();
  void couple(const StepWeights& weights, Couplings& couplings) const;
  [[nodiscard]] static Kinematics extrapolated(const Kinematics& from, const Curvature& curvature,
                                               double length);
  void extrapolate(double length);
  void interpolate(double share, double length);
  /// Whether joints may turn, and their tangents jump, in a step that is solved.
  enum class Breakpoints { kNone, kAllowed };
  [[nodiscard]] bool solve(const StepWeights& weights, Couplings& couplings,
                           Breakpoints breakpoints);
  [[nodiscard]] bool step_over_breakpoints(const StepWeights& weights);
  enum class Paths { kSame, kOthers, kUnclear };
  [[nodiscard]] Paths find_paths(double length, Couplings& couplings);
  void couple_breakpoints(double length, Couplings& couplings);
  [[nodiscard]] static StepQuartic path(const Joint& joint, double length);
  [[nodiscard]] static StepCubic force_cubic(const Joint& joint, double length);
  [[nodiscard]] double add_inner_forces(double length, bool middles, const Couplings& couplings);
  [[nodiscard]] static double middle_force(const Joint& joint, const StepCubic& force,
                                           double length);
  void pass_breakpoints(Joint& joint);
  [[nodiscard]] static Curvature curvature(const Joint& joint, double length);
  void place(const StepWeights& weights, const Couplings& couplings);
  void place_by_modes(const StepWeights& weights);
  void accelerate(double length);
  void begin_accelerations();
  static void drive_damper(const Joint& joint, double tangent, Kinematics& k);
  [[nodiscard]] double update(std::size_t j, const Couplings& couplings, double length,
                              bool settled);
  void load_modes();
  void correct(const StepWeights& weights);
  enum class Quadrature { kInner, kEnds };
  void accept(double length, Quadrature quadrature);
  void add_energies(double length, Quadrature quadrature);
  void look_inside(double length);
  [[nodiscard]] bool solve_piece(double length, const StepWeights& whole);
  [[nodiscard]] Change first_change(double length);
  [[nodiscard]] static double turning_share(const Joint& joint, const StepCubic& y, double length);
  [[nodiscard]] static double kink_share(const Joint& joint, const StepCubic& y, double until);
  void change(const Change& change);
  void set_off(Joint& joint);
  static void find_kink(Joint& joint);
  void turn(Joint& joint);
  void pass_kink(Joint& joint);
  void pass_kinks();

  double tolerance_;
  int max_iterations_;
  std::size_t groups_;        // of modes
  std::size_t joint_groups_;  // of joints
  bool shortens_;
  bool damped_ = false;
  std::vector<double> stiffness_, damping_;        // ω², ηω
  std::vector<double> q_, v_, load_, load_slope_;  // at the beginning of a step
  std::vector<double> end_q_, end_v_, end_load_, end_load_slope_, end_force_, end_a_;
  std::vector<double> end_load_middle_, predicted_q_, predicted_v_;
  std::vector<double> predicted_slide_, predicted_slide_dot_, slide_, slide_dot_;  // of the joints
  std::vector<Joint> joints_;
  Loads loads_;
  StepWeights cut_;  // of parts of a step
  BreakpointWeights breakpoint_weights_;
  StepQuadrature quadrature_;
  std::vector<double> breakpoints_inside_;  // of march_loops::inner_energies()
  bool any_breakpoints_inside_ = false;     // else it is zero
  double longest_over_breakpoints_ = 0.0;   // step, s
  Couplings couplings_, cut_couplings_;
  double contraction_ = 1.0;  // from one change of the joint forces to the next
  double initial_energy_ = 0.0;
  double input_ = 0.0;
  double loss_ = 0.0;
  std::size_t steps_ = 0;
  std::size_t reversals_ = 0;
  std::size_t kinks_ = 0;
  std::size_t evaluations_ = 0;
  double last_change_ = 0.0;
};

}  // namespace microslip
