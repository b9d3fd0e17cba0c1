// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "microslip/signal/decay/tapered_transform.hpp"

/// @file
/// A tapered window as a least-squares fit sees it: its samples, or far fewer nodes that give the
/// same sums. Internal to signal.
///
/// A fit of a smooth m(τ) under the taper w needs of the samples y only the sums Σ w y e^{−iω₀τ}m*,
/// and w vanishes at both ends with three derivatives. Where L_k are the polynomials of
/// interpolation between the 8 nearest of evenly spaced nodes, m(τ) = Σ L_k(τ) m(τ_k), and
///
///     Σ_i w_i y_i e^{−iω₀τ_i} m*(τ_i) = Σ_k V_k m*(τ_k)
///     V_k = Σ_i L_k(τ_i) w_i y_i e^{−iω₀τ_i}
///
/// so that the N values z_k = 2V_k N/(n w_k) stand for n samples: those of the window, brought
/// to the frequency 0 and filtered by the polynomials. What turns x times between two nodes is off
/// by 10⁻³(2πx)⁸: beside the mode by 10⁻⁸. The squares of m are left without the term of 2ω₀, which
/// the taper suppresses over d = 2ω₀T/2π lines as a neighbour by side_lobe(d); with 40 lines or
/// more it moves δT by 3·10⁻⁷ at most. With fewer periods the nodes are those of the signal as it
/// is, ω₀ = 0 and real.

namespace microslip {

class WindowNodes {
 public:
  /// @param from, to  rad/s: where the mode is sought.
  WindowNodes(const TaperedWindow& window, double from, double to);

  [[nodiscard]] std::size_t size() const { return place_.size(); }
  [[nodiscard]] double place(std::size_t k) const { return place_[k]; }  ///< 2τ/T
  [[nodiscard]] double weight(std::size_t k) const { return weight_[k]; }
  /// The signal beside the mode is the real part of z e^{iω₀τ}; real values are the signal's.
  [[nodiscard]] std::complex<double> value(std::size_t k) const { return value_[k]; }
  /// ω₀, rad/s; 0 where the values are real.
  [[nodiscard]] double carrier() const { return carrier_; }
  [[nodiscard]] bool is_complex() const { return carrier_ > 0.0; }
  /// n/N, the samples that one value stands for; of a complex one, which is two, the half.
  [[nodiscard]] double samples() const { return samples_; }
  [[nodiscard]] double length() const { return length_; }  ///< T, s

  /// The frequency of the largest transform between `from` and `to`, to T⁻¹/8. rad/s.
  [[nodiscard]] double strongest() const { return strongest_; }

  /// Σ w y e^{−iωτ}/Σ w of values at the nodes, those of the window or a residual; within
  /// kReach lines of the mode where it is complex.
  [[nodiscard]] std::complex<double> transform(const std::vector<std::complex<double>>& values,
                                               double omega) const;
  /// The same under a taper cos⁴ of half the length about −T/4 or T/4; τ from the middle of both.
  [[nodiscard]] std::complex<double> half_transform(int which, double omega) const;

  /// The values of all nodes.
  [[nodiscard]] const std::vector<std::complex<double>>& values() const { return value_; }

  /// Lines of 1/T about the mode within which the nodes hold the signal.
  static constexpr double kReach = 16.0;
  /// Whether they hold it at a frequency. rad/s.
  [[nodiscard]] bool holds(double omega) const;

 private:
  void take_samples(const TaperedWindow& window);
  void take_nodes(const TaperedWindow& window, double carrier, std::size_t count);
  [[nodiscard]] double strongest_between(double from, double to) const;
  template <typename Weight>
  [[nodiscard]] std::complex<double> sum_of(const std::vector<std::complex<double>>& values,
                                            double omega, const Weight& weight) const;

  double length_;
  std::vector<double> place_;
  std::vector<double> weight_;
  std::vector<std::complex<double>> value_;
  double carrier_ = 0.0;
  double samples_ = 1.0;
  double strongest_ = 0.0;
  double highest_ = 0.0;  ///< rad/s, up to which real nodes hold the signal; 0: all
};

}  // namespace microslip
