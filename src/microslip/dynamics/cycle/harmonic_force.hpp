// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "microslip/dynamics/cycle/cycle_motion.hpp"
#include "microslip/joint/joint.hpp"

namespace microslip {

class SteadyCycle;

/// The harmonics of the force of a joint in steady periodic motion, with their derivatives: the
/// alternating frequency/time method [Cameron & Griffin, J. Appl. Mech. 56 (1989) 149] with the
/// exact memory of the Iwan joint.
///
///     x(τ) = Re Σ_{n=0}^{H} x_n e^{inτ}   →   f(τ) ≈ Re Σ_{n=0}^{H} f_n e^{inτ}
///
/// Real numbers in this order: (x_0, Re x_1, Im x_1, …, Re x_H, Im x_H), m, and so for f, N.
///
/// The joint was at rest and virgin at x = 0 before. In steady motion its only memory at the
/// extreme of largest |x| is the virgin curve; from there one cycle with Madelung's rules (see
/// Memory), inner loops included, is the steady one. The extremes are those of the trigonometric
/// polynomial itself, found by Newton's method between the samples, so that the force at each of
/// the N samples is exact. The sum over samples that replaces the integral is corrected for the
/// kinks of the force at reversals, closing loops and atoms. The error in N is of the order N^−4,
/// where the density jumps N^−3 (observed). Two reversals between two samples are missed.
///
/// On each branch df = f_r′ + F′(|x − x_r|/2)(dx − dx_r) with f_r′ the change of the force at its
/// reversal r: the derivatives follow the reversals through the cycle. They are those of the f_n
/// returned but for terms of the order N^−3 at kinks, some 1e-7 k with 512 samples.
///
/// Holds tables and working memory; not for two threads at once.
class HarmonicForce {
 public:
  /// @param harmonics  H, from 1 to 1000.
  /// @param samples    N, from 2H + 2 to 1e6: fewer do not determine harmonic H.
  /// @throws InputError  naming the one out of its range.
  HarmonicForce(std::size_t harmonics, std::size_t samples);
  ~HarmonicForce();
  /// The other may only be destroyed or assigned to afterwards.
  HarmonicForce(HarmonicForce&&) noexcept;
  HarmonicForce& operator=(HarmonicForce&&) noexcept;  ///< As the constructor.

  using Cycle = CycleMotion;  ///< motion found by evaluate()

  /// f_n of the displacement x_n, with the derivatives.
  /// @param joint         any.
  /// @param displacement  2H + 1 values, m; finite.
  /// @param force         2H + 1 values, N.
  /// @param jacobian      ∂force_i/∂displacement_j at i(2H + 1) + j, N/m.
  /// @throws InputError  for a wrong length or a displacement that is not finite.
  Cycle evaluate(const Joint& joint, std::span<const double> displacement, std::span<double> force,
                 std::span<double> jacobian);

  /// Extents of the branches of the motion evaluated last, m: |x| at the extreme of the largest
  /// |x|, from virgin rest, and half of the distance from each reversal to the next on its branch,
  /// inner loops included. An atom slips on a branch longer than its slip force over k: there f
  /// bends.
  [[nodiscard]] std::size_t reaches() const;
  /// One of them. @param rank  from 0, the farthest, below reaches().
  [[nodiscard]] double reach(std::size_t rank) const;
  /// Its derivatives.
  /// @param rank      as for reach().
  /// @param gradient  ∂reach/∂displacement_j at j, 1; 2H + 1 values.
  void reach_gradient(std::size_t rank, std::span<double> gradient) const;

  using Turn = CycleTurn;  ///< a reversal of the motion evaluated last
  /// Number of reversals in a period: 0 at rest, else even.
  [[nodiscard]] std::size_t turns() const;
  /// A reversal, in the order of time. @param i  below turns().
  [[nodiscard]] Turn turn(std::size_t i) const;
  /// The derivatives of the displacement of a reversal.
  /// @param i         as for turn().
  /// @param gradient  ∂x/∂displacement_j at j, 1; 2H + 1 values.
  void turn_gradient(std::size_t i, std::span<double> gradient) const;

 private:
  std::unique_ptr<SteadyCycle> cycle_;
};

}  // namespace microslip
