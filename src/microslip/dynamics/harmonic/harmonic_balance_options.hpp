// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/dynamics/harmonic/target.hpp"

namespace microslip {

/// How HarmonicBalance discretises and solves.
struct HarmonicBalanceOptions {
  /// H: harmonics 0 to H are kept; from 1, and from the highest of the excitation. 3 serve where
  /// the joint hardly slips, 9 in macro-slip.
  std::size_t harmonics = 5;
  /// N, samples of a cycle for the joint forces; from 2H + 2. The error is of the order N^−4, N^−3
  /// where the density jumps (see HarmonicForce): some 1e-8 of the force with 256.
  std::size_t samples = 256;
  /// Largest residual, relative, 1: of the balance to the motion of the joint, of a target to its
  /// value (a phase: in rad); from 1e-14 to 1e-4. Where rounding does not let it fall so far, 1e-10
  /// is enough. The energy balance multiplies it by the energy stored over that lost.
  double tolerance = 1e-12;
  /// Evaluations of the equations that one solution may take; ≥ 2.
  int max_iterations = 40;
  /// Change of the response and of each joint's motion from one point of a curve to the next,
  /// relative, 1; in (0, 1]. 0.2 draws the half-width of a resonance with some ten points.
  double largest_change = 0.2;
  /// Fewest points of a curve over the range without resonances; ≥ 1.
  int least_points = 20;
  /// Points of a curve at most; ≥ 2.
  int max_points = 5000;
  /// Largest interpolation error of the polygon through the points of a curve over the frequency,
  /// at a frequency, relative to the peak of its hill, 1: of the response, or, where that is
  /// constant, of the force, relative to the force there. Points are added until those between them
  /// agree; 0: none are added.
  double accuracy = 0.002;
  /// Where a curve over the frequency is to have points as well, ω, rad/s; on each of its branches
  /// there.
  std::vector<double> frequencies = {};
  /// Forcing of the vibration. Modal forcing gives nonlinear modes only: in solve() it takes phase
  /// resonance, which then only sets the zero of time, with a response or a frequency.
  Forcing forcing = Forcing::kExcitation;
};

}  // namespace microslip
