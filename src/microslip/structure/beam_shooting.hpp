// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "microslip/structure/uniform_beam.hpp"

/// @file
/// The exact solutions of the beam equation at a frequency, from the clamp to the spring. Lengths
/// are over L, so that with λ⁴ = ω² ρA L⁴/EI the equation is w⁗ = λ⁴w between the masses.
///
/// Why exact and by marching: the roots of the textbook determinant are lost where two are close,
/// and its hyperbolic functions overflow; a dynamic stiffness matrix has poles, and cancels between
/// two masses at almost one place; finite elements are dear where ten digits are wanted. Here the
/// beam is cut into elements of λh ≤ 2, over which nothing grows by more than a factor e² and which
/// have no natural frequency of their own below λ when clamped (λh = 4.73). The two solutions that
/// the clamp leaves are carried from element to element and made orthonormal at each [Conte]: every
/// number stays near 1, for any mode, mass and spacing.

namespace microslip {

/// (w, w′/λ, w″/λ², w‴/λ³).
using BeamState = std::array<double, 4>;

/// Duncan's functions K0 = (cosh z + cos z)/2, K1 = (sinh z + sin z)/2, K2 = (cosh z − cos z)/2,
/// K3 = (sinh z − sin z)/2, each the derivative of the next one, K3 that of K0.
using DuncanFunctions = std::array<double, 4>;

/// Duncan's functions to rounding, each relative to itself. @param z  in [0, 2].
[[nodiscard]] DuncanFunctions duncan_functions(double z);

/// The state at a distance z/λ behind the given one.
[[nodiscard]] BeamState carried(const DuncanFunctions& k, const BeamState& y);

/// (ω² ρA L⁴/EI)^¼.
[[nodiscard]] double wavenumber(const Beam& beam, double angular_frequency);
/// λ² √(EI/(ρA L⁴)), rad/s.
[[nodiscard]] double angular_frequency(const Beam& beam, double wavenumber);

class BeamShooting {
 public:
  /// Equal elements between two places with a mass.
  struct Segment {
    double start;          ///< over L
    double element;        ///< the length of an element, over L
    std::size_t elements;  ///< at least 1
    double mass;           ///< at its end, over ρAL; 0 at the end of the beam
  };

  /// Two solutions at a place.
  struct Pair {
    BeamState a;
    BeamState b;
  };

  /// @param beam                checked by the caller.
  /// @param largest_wavenumber  the largest λ that march() will be called with.
  BeamShooting(const Beam& beam, double largest_wavenumber);

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }
  [[nodiscard]] std::size_t elements() const { return nodes_.size() - 1; }

  /// The functions below refer to the last λ.
  void march(double wavenumber);

  /// The number of natural frequencies below λ.
  [[nodiscard]] std::size_t below() const { return below_; }
  /// How far the solutions are from meeting the conditions at L: smooth in λ, of the order 1, zero
  /// at the natural frequencies alone, its sign (−1)^below().
  [[nodiscard]] double defect() const;
  /// k_θ L/EI of the spring with which λ is a natural frequency.
  [[nodiscard]] double matching_spring() const;
  /// The solution that meets the conditions at L, at a natural frequency: its states behind each
  /// node, from the clamp to L. Of any scale, with w′(L) < 0.
  /// @param states  one per node, elements() + 1.
  void solution(BeamState* states) const;

 private:
  /// Two orthonormal solutions behind a node. Coordinates in them, times `back`, are those in the
  /// solutions of the node before.
  struct Node {
    Pair solutions;
    std::array<double, 4> back;  // 2×2 by rows
  };

  /// The condition at L: bending·w″/λ² + spring·w′/λ = 0, bending + spring = 1.
  struct Shares {
    double bending;
    double spring;
  };

  void start_march();
  [[nodiscard]] Shares shares() const;

  std::vector<Segment> segments_;
  double tip_stiffness_;  // k_θ L/EI
  double wavenumber_ = 0.0;
  std::size_t below_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace microslip
