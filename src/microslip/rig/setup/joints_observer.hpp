// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"

namespace microslip {

/// The motion of one steady cycle of a structure with joints. Series without mean, of one ω.
struct JointsMotion {
  std::vector<FourierSeries> modal;         ///< q_i of the modes of the structure, m√kg
  std::vector<FourierSeries> displacement;  ///< u_j, one per joint, m
  std::vector<FourierSeries> force;         ///< F_j, the restoring forces, N
  FourierSeries excitation;                 ///< f, N: as measured, corrected by the accelerometers
  /// Per accelerometer: ‖measured − explained by the motion‖/‖measured‖ over the harmonics, 1.
  std::vector<double> misfit;
};

/// A combination of joint forces in one harmonic that the accelerometers do not show.
struct UnseenDirection {
  std::size_t harmonic = 1;         ///< n
  std::vector<double> participant;  ///< |share| of each joint's force in it, of length 1
};

/// Noise of the Fourier coefficients of a record, and how much the joints can do.
struct JointsObserverScales {
  /// Standard errors of Re F_n and Im F_n, entry n − 1, N; ≥ 0.
  std::vector<double> force_std;
  /// [accelerometer][n − 1], standard deviation of A_jn, m/s²; ≥ 0.
  std::vector<std::vector<double>> acceleration_std;
  /// s_j, N; > 0: the force that joint j would have if it stuck, in its first harmonic. In harmonic
  /// n a joint is not taken to do more than s_j/n beyond sticking.
  std::vector<double> joint_force;
};

/// Checks that JointsObserver can observe a structure.
/// @param structure       with its joints and its excitation.
/// @param accelerometers  their number.
/// @throws InputError  where there is no joint, one has shortening, there are several excitations,
///                     or there is no accelerometer.
void check_observable(const JointedStructure& structure, std::size_t accelerometers);

/// Observes the motion of the joints of a structure from its force and its accelerations.
///
/// With the joints stuck (k_j, and the compliance in series) the structure is linear. The nonlinear
/// force of joint j, h_j = k_j′u_j − F_j, is one unknown complex number per harmonic:
///
///     A_n = −(nω)² S Z_n⁻¹ [φ F_n + Ψ h_n] + noise,
///     Z_n = diag(ω_i² − (nω)² + damping) + Σ_j (k_j′ − k_s,j) ψ_jψ_jᵀ
///
/// with S the shapes at the accelerometers, φ that at the exciter and Ψ those of the joints. h_n is
/// that of generalised least squares: close to a resonance the noise of F_n moves all accelerations
/// together, so that it is in their covariance diag(σ_j²) + σ_F² b bᴴ, b = −(nω)² S Z_n⁻¹ φ
/// [Aitken]. All modes take part however few the accelerometers are; the modes stay those in which
/// the damping is known.
///
/// Combinations of the h_j (by singular values of their observed accelerations, over the noise) in
/// which noise is more than a third of s_j/n are not observed. There the joints are taken to stick,
/// h = 0, and s_j/n is the standard deviation of that: unseen(). No other is damped.
class JointsObserver {
 public:
  /// @param structure       is copied. One excitation; joints without shortening.
  /// @param accelerometers  names of points, one at least.
  /// @param omega           ω of the cycle, rad/s; above 0.
  /// @param harmonics       H; 1 or more.
  /// @param scales          see there.
  /// @throws InputError  as check_observable(), where they are out of range or a point is missing.
  JointsObserver(const JointedStructure& structure, std::span<const std::string> accelerometers,
                 double omega, std::size_t harmonics, const JointsObserverScales& scales);
  ~JointsObserver();
  /// The other may only be destroyed or assigned to afterwards.
  JointsObserver(JointsObserver&&) noexcept;
  JointsObserver& operator=(JointsObserver&&) noexcept;  ///< As the constructor.

  /// The motion in one cycle.
  /// @param force          f, N.
  /// @param accelerations  one per accelerometer, m/s².
  /// @throws InputError  where ω differs, or the number of accelerations.
  [[nodiscard]] JointsMotion observe(const FourierSeries& force,
                                     std::span<const FourierSeries> accelerations) const;

  /// The unobserved directions: first harmonics before higher ones.
  [[nodiscard]] std::span<const UnseenDirection> unseen() const;

  /// observe() with one of unseen() not 0 but s, the standard deviation of it.
  /// @param force          f, N.
  /// @param accelerations  one per accelerometer, m/s².
  /// @param direction      of unseen().
  /// @param phase          of s, rad.
  /// @throws InputError  as observe().
  [[nodiscard]] JointsMotion observe_with(const FourierSeries& force,
                                          std::span<const FourierSeries> accelerations,
                                          std::size_t direction, double phase) const;

  /// Standard errors of Re u_jn and Im u_jn by the noise alone, entry n − 1, m.
  /// @param joint  j. @throws InputError  where there are not so many.
  [[nodiscard]] std::vector<double> displacement_std(std::size_t joint) const;

 private:
  struct Tables;
  std::unique_ptr<const Tables> tables_;
};

}  // namespace microslip
