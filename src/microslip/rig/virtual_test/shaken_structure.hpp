// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/rig_structure.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/rig/virtual_test/broyden.hpp"
#include "microslip/rig/virtual_test/driven_vibration.hpp"

namespace microslip {

/// A rig with its joint under a force of several harmonics.
class RigInMotion {
 public:
  /// The references must outlive the object.
  RigInMotion(const Rig& rig, const StickState& state, const Joint& joint,
              HarmonicBalanceOptions options, double linear_damping)
      : rig_(rig),
        state_(state),
        joint_(joint),
        modes_(rig_modes(rig, state)),
        options_(options),
        linear_damping_(linear_damping) {}

  /// @param force  s_1, s_2, …: see Excitation.
  [[nodiscard]] HarmonicBalance balance(std::vector<std::complex<double>> force = {1.0}) const;

  [[nodiscard]] const Rig& rig() const { return rig_; }
  [[nodiscard]] const StickState& state() const { return state_; }
  [[nodiscard]] std::size_t harmonics() const { return options_.harmonics; }
  /// Stiffness of the spring in the modes, N/m.
  [[nodiscard]] double stuck_stiffness() const;
  /// w_n at the exciter, entry n; m.
  [[nodiscard]] std::vector<std::complex<double>> exciter_displacement(
      const SteadyVibration& vibration) const;
  /// w/F at Ω of the linear structure whose joint is softer than stuck by δ, N/m; m/N.
  [[nodiscard]] std::complex<double> receptance(double angular_frequency,
                                                std::complex<double> softening) const;

 private:
  const Rig& rig_;
  const StickState& state_;
  const Joint& joint_;
  ModalModel modes_;
  HarmonicBalanceOptions options_;
  double linear_damping_;  // of the joint
};

/// Structure, joint and shaker together at one frequency of the drive and one response, which V_1
/// controls. It is driven by the voltages of the generator v_2 … v_H, in phase with V_1: V_n = v_n
/// e^{inθ}, θ = arg V_1. Internal to rig.
class ShakenStructure {
 public:
  /// @param start  a vibration of this rig near the one sought.
  ShakenStructure(const RigInMotion& motion, const RigShaker& shaker, double angular_frequency,
                  double response, SteadyVibration start);

  struct Outcome {
    DrivenVibration driven;
    Eigen::VectorXcd force;  ///< F_n e^{−inθ}/F_1, n = 2 … H: input of the controller
    double drive = 0.0;      ///< |V_1|, V
    Summary summary;
  };

  /// The steady state, from the last one. Unknown are the harmonics of the force; each trial of
  /// them is a harmonic balance, and F_n = a_n V_n − b_n w_n is to hold. With the receptance R_n of
  /// the stuck structure that is r_n = [a_n (V_n − v_n e^{inθ})]/(1 + b_n R_n) = 0 for Broyden's
  /// method, V_n being the voltage that F_n and w_n need; this is returned, so that the equations
  /// of the shaker hold to rounding, and the generator's voltage to the residual.
  [[nodiscard]] Outcome settle(const Eigen::VectorXcd& generator);

  /// H_n = a_n/(1 + b_n R_n), n = 2 … H, N/V: of Outcome::force times F_1 over v_n, where the joint
  /// is the linear one of R_n.
  [[nodiscard]] Eigen::VectorXcd linear_transfer() const;

 private:
  /// The vibration under shape_.
  void solve();
  /// V_n that last_ needs.
  void find_voltage();
  [[nodiscard]] Outcome outcome() const;
  [[nodiscard]] Eigen::VectorXcd residual(const Eigen::VectorXcd& generator) const;

  const RigInMotion& motion_;
  double angular_frequency_;
  double response_;
  std::vector<std::complex<double>> per_voltage_;       // a_n
  std::vector<std::complex<double>> per_displacement_;  // b_n
  std::vector<std::complex<double>> loaded_;            // 1 + b_n R_n
  SteadyVibration last_;
  Eigen::VectorXcd shape_;  // s_n = F_n/F_1, n = 2 … H
  Broyden broyden_;
  std::vector<std::complex<double>> voltage_;  // V_n of the last trial; empty before it
  Summary summary_;
};

}  // namespace microslip
