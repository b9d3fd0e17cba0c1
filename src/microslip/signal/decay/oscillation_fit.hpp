// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "microslip/algebra/core.hpp"

/// @file
/// Least squares of one or two damped oscillations on the transforms of short windows along a
/// decay. Internal to signal.

namespace microslip {

/// Z at times one hop apart: the transform of tapered windows at ω₀, without the turning of ω₀.
struct Baseband {
  double begin = 0.0;   ///< s, centre of the first window
  double hop = 0.0;     ///< s
  double length = 0.0;  ///< T of the windows, s
  double omega = 0.0;   ///< ω₀, rad/s
  double fall = 1.0;    ///< of ln A over the decay; above 0
  double decay = 0.0;   ///< 1/s: of the mode on average, the unit of all rates
  Eigen::VectorXcd value;
  Eigen::VectorXd root;  ///< 1/σ of each value

  /// Degrees of freedom of the values, which overlap.
  [[nodiscard]] double independent() const;
};

/// The fitted model of the mode, and a second oscillation, damped or steady. δ and ω − ω₀ of the
/// mode are polynomials of given numbers of coefficients over the share s of the fall of ln A, 0 to
/// 1; or those of a mode with a joint, of which δ is near a power of A and what ω lacks is near
/// another: ln δ cubic in s, ω − ω₀ = w₀ − w₁A^m − w₂A^2m. These follow few beats of a second
/// oscillation much less than polynomials do.
struct OscillationModel {
  int decays = 1;
  int omegas = 1;
  bool second = false;
  bool steady = false;  ///< the second does not decay
  bool joint = false;   ///< δ and ω of a mode with a joint; decays and omegas are 4 each

  /// Parameters of the mode.
  [[nodiscard]] int of_mode() const { return decays + omegas; }
};

/// A model on values. Parameters: coefficients of δ, those of ω − ω₀, then Δ and δ₂ of the second
/// oscillation, all over the mean decay rate; of a joint four coefficients of ln δ, then w₀, w₁, w₂
/// and m. The complex amplitudes c₁ and c₂ are the best for these.
class OscillationFit {
 public:
  OscillationFit(const Baseband& band, const OscillationModel& model)
      : band_(band), model_(model) {}

  [[nodiscard]] double first_decay(const Eigen::VectorXd& p) const;  ///< δ at the first value, 1/s
  [[nodiscard]] double first_omega(const Eigen::VectorXd& p) const;  ///< ω − ω₀ there, rad/s
  [[nodiscard]] double second_omega(const Eigen::VectorXd& p) const;  ///< Δ, rad/s
  [[nodiscard]] double second_decay(const Eigen::VectorXd& p) const;  ///< δ₂, 1/s

  /// e^{x + iθ} of the mode at each value.
  [[nodiscard]] Eigen::VectorXcd mode(const Eigen::VectorXd& p) const;

  /// e^{(−δ₂ + iΔ)t} at each value.
  [[nodiscard]] Eigen::VectorXcd second(double omega, double decay) const;

  /// Weighted, real parts and then imaginary ones; sets the amplitudes.
  Eigen::VectorXd residual(const Eigen::VectorXd& p);

  /// The residual for given time histories of the two. @param beside  empty for the mode alone.
  Eigen::VectorXd residual_of(const Eigen::VectorXcd& mode, const Eigen::VectorXcd& beside);

  /// Levenberg–Marquardt. @return  whether it converged.
  bool minimise(Eigen::VectorXd& p);

  /// χ² of the last residual by the degrees of freedom of the values.
  [[nodiscard]] double chi_square() const { return chi_square_; }
  [[nodiscard]] std::complex<double> first_amplitude() const { return first_; }
  [[nodiscard]] std::complex<double> second_amplitude() const { return second_; }

 private:
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& p, const Eigen::VectorXd& now);

  const Baseband& band_;
  OscillationModel model_;
  std::complex<double> first_ = 0.0;
  std::complex<double> second_ = 0.0;
  double chi_square_ = HUGE_VAL;
};

}  // namespace microslip
