// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"

namespace microslip {

/// The motion of one steady cycle. Series without mean, of one ω.
struct ModalMotion {
  std::vector<FourierSeries> modal;  ///< q_i, m√kg
  FourierSeries rotation;            ///< Σ ψ_i q_i, m: for a beam r w′(L)
  FourierSeries kinematic;           ///< u by the kinematics, m [AR14 (13)]
  FourierSeries joint_force;         ///< F_joint, N
  double softening = 0.0;            ///< δ = Re(g_1/(Σψ_i q_i)_1), N/m
  double mean_shortening = 0.0;      ///< mean of −½ Σ Γ_ir q_i q_r over the cycle, m; ≤ 0
  /// Per accelerometer: ‖measured − explained by the motion‖/‖measured‖ over the harmonics, 1.
  std::vector<double> misfit;
};

/// Finds the motion of a structure from its force and its accelerations.
///
/// The only unknown in the equation of StickState is the force of the joint, g: one complex number
/// per harmonic. It is found from the accelerations by least squares,
///
///     q_in = [φ_i(S) F_n + ψ_i g_n − (Γ q N)_in] / [ω_i²(1 + iη_i) − (nω)²],
///     g_n = arg min Σ_j |Σ_i φ_i(x_j) q_in + A_jn/(nω)²|²,
///
/// so that all modes take part however few the accelerometers are, and the modes stay those of the
/// stick state, in which the linear damping was identified. (Fitting as many modal coordinates as
/// there are accelerometers leaves the others out: for three, 0.2 % of the linear dissipation and
/// 1 % of the joint displacement at the highest level of the reference rig.) The quadratic term of
/// the shortening is found by iteration, without the means of q and N, which accelerometers do not
/// measure.
class ModalObserver {
 public:
  /// @param state      is copied.
  /// @param omega      ω of the cycle, rad/s; above 0.
  /// @param harmonics  H; 1 or more.
  /// @throws InputError  where they are out of range, or the joint moves no accelerometer: φ_i(x_j)
  ///                     ψ_i is 0 throughout.
  ModalObserver(const StickState& state, double omega, std::size_t harmonics);
  ~ModalObserver();
  /// The other may only be destroyed or assigned to afterwards.
  ModalObserver(ModalObserver&&) noexcept;
  ModalObserver& operator=(ModalObserver&&) noexcept;  ///< As the constructor.

  /// The motion in one cycle.
  /// @param force          f, N.
  /// @param accelerations  one per accelerometer of the state, m/s².
  /// @throws InputError  where ω differs, or the number of accelerations.
  [[nodiscard]] ModalMotion observe(const FourierSeries& force,
                                    std::span<const FourierSeries> accelerations) const;

 private:
  struct Tables;
  std::unique_ptr<const Tables> tables_;
};

}  // namespace microslip
