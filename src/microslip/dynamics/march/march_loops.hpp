// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

/// @file
/// The loops over the modes of a march, in groups of kLanes (march_weights.hpp). Each lane has sums
/// of its own, so that they are the same whatever the vectors of the processor. Internal to
/// dynamics.

namespace microslip::march_loops {

/// One number per mode each.
struct State {
  const double* displacement;  ///< q
  const double* velocity;      ///< q̇
  const double* joint_load;    ///< of the joints on the mode
  const double* joint_slope;   ///< its slope in time
  const double* force;         ///< of the external forces on the mode
};

/// The part of q₁ and q̇₁ that does not depend on the joints at the end of the step. The external
/// load is force + slope·t.
void predict(std::size_t groups, const double* weights, double length, const State& from,
             const double* slope, double* q, double* v);

/// A force on the modes and its slope, on top of `kept` (0 or 1) times what is there.
void add_force(std::size_t groups, double kept, const double* shape, double value, double slope,
               double* force, double* force_slope);

/// The loads of one joint on the modes, −ψ_i R, their slopes, −ψ_i Ṙ, and what they are more in the
/// middle of the step, −ψ_i R_m, on top of `kept` (0 or 1) times what is there.
void add_loads(std::size_t groups, double kept, const double* shape, double r, double r_dot,
               double r_middle, double* load, double* slope, double* middle);

/// Adds the loads of a joint with shortening, gF and gḞ + ġF.
void add_shortening_loads(std::size_t groups, double kept, const double* shape, double r,
                          double r_dot, const double* g, const double* g_dot, double force,
                          double force_dot, double* load, double* slope);

/// q = q_predicted + a₁ load + b₁ slope + a_m middle, and so q̇.
void correct(std::size_t groups, const double* weights, const double* predicted_q,
             const double* predicted_v, const double* load, const double* slope,
             const double* middle, double* q, double* v);

/// q̈ = load + force − ηω q̇ − ω² q.
void accelerate(std::size_t groups, const double* stiffness, const double* damping,
                const double* load, const double* force, const double* q, const double* v,
                double* a);

/// shape·a.
[[nodiscard]] double dot(std::size_t groups, const double* shape, const double* a);

struct Pair {
  double q;
  double v;
};

/// shape·q and shape·v.
[[nodiscard]] Pair project(std::size_t groups, const double* shape, const double* q,
                           const double* v);

/// g = Γq and ġ = Γv; gamma symmetric, padded. @return g·q and g·v.
Pair shorten(std::size_t groups, const double* gamma, const double* q, const double* v, double* g,
             double* g_dot);

/// Σ_i ψ_i w_i χ_i of two shapes for the weights w of the loads at the end and in the middle, in
/// the order of CouplingKind.
enum CouplingKind { kCoupledA1, kCoupledB1, kCoupledAM, kCoupledC1, kCoupledD1, kCoupledCM };
inline constexpr std::size_t kCouplings = 6;
using Coupling = std::array<double, kCouplings>;
[[nodiscard]] Coupling couple(std::size_t groups, const double* weights, const double* shape,
                              const double* other);

/// Subtracts the effect of one joint at the end of a step, and in its middle, from the slides of
/// all.
/// @param groups   of joints. @param coupling  of the joint with each, [kind][joint].
void move_slides(std::size_t groups, const double* coupling, double r, double r_dot,
                 double r_middle, double* slide, double* slide_dot);

/// Subtracts the effect of its breakpoints. @param coupling  [term][kind][joint].
/// @param moments  the first that count.
void move_slides_by_breakpoints(std::size_t groups, const double* coupling,
                                std::span<const double> moments, double* slide, double* slide_dot);

/// Adds the contribution of the breakpoints of one joint to q and q̇: −ψ_i Σ_m w_im M_m.
/// @param weights  of BreakpointWeights. @param moments  the first that count, at most
/// kBreakpointTerms.
void add_breakpoints(std::size_t groups, const double* weights, const double* shape,
                     std::span<const double> moments, double* q, double* v);

/// Σ_i ψ_i w_im χ_i of two shapes, [term][kind], as BreakpointWeights has them.
void couple_breakpoints(std::size_t groups, const double* weights, const double* shape,
                        const double* other, double* coupling);

struct Energies {
  double input;  ///< ∫ force·q̇ dt, J
  double loss;   ///< Σ ηω ∫ q̇² dt, J
};

/// Energies over one step by StepQuadrature.
/// @param weights  of it. @param slope  of the external forces.
/// @param middle   excess of the loads of the joints in the middle of the step.
/// @param breakpoints    −Σ_j ψ_ij ∫ e_j over the shares up to each inner point, [point][mode].
[[nodiscard]] Energies inner_energies(std::size_t groups, double length, const double* weights,
                                      const double* damping, const State& from, const State& to,
                                      const double* slope, const double* middle,
                                      const double* breakpoints);

/// Over a piece of a step by q and q̇ and their derivatives at its ends, both of fourth order:
/// ∫q dt = ½h(q₀ + q₁) + h²/12 (q̇₀ − q̇₁), and so of q̇².
[[nodiscard]] Energies step_energies(std::size_t groups, double length, const double* stiffness,
                                     const double* damping, const State& from, const State& to,
                                     const double* slope);

}  // namespace microslip::march_loops
