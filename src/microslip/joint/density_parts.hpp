// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

/// @file
/// The parts that a density is the sum of, and the moments of a part or of all of them.

namespace microslip {

/// φ = weight/(to − from) on [from, to].
struct UniformPart {
  double from;    ///< slip force, N; ≥ 0
  double to;      ///< slip force, N; > from
  double weight;  ///< share of the stiffness, 1; ≥ 0
};

/// φ = coefficient·f*^exponent on [from, to], [AR14 (6)].
struct PowerLawPart {
  double coefficient;  ///< R, N^−(1+exponent); ≥ 0
  double exponent;     ///< χ, 1; finite, and > −1 where from = 0 (else the area is infinite)
  double from;         ///< slip force, N; ≥ 0
  double to;           ///< slip force, N; > from
};

/// φ linear between the knots and zero outside of them.
struct PiecewiseLinearPart {
  std::vector<double> slip_force;  ///< N; at least 2, ≥ 0, strictly increasing
  std::vector<double> density;     ///< 1/N; one per knot, ≥ 0
};

/// φ = Σ weight_i δ(f* − slip_force_i): finite shares of stiffness with one slip force.
struct AtomsPart {
  std::vector<double> slip_force;  ///< N; > 0, any order
  std::vector<double> weight;      ///< share of the stiffness, 1; one per atom, ≥ 0
};

/// Segalman's four-parameter model: over the slip displacement ψ, Rψ^χ on [0, ψ_max] plus an atom S
/// at ψ_max. Its area is 1, so it stands alone in a density. [Segalman, J. Appl. Mech. 72 (2005)
/// 752]
struct FourParameterPart {
  double macroslip_force;  ///< F_S, N; > 0
  double stiffness;        ///< K_T, N/m; > 0; the stiffness of the joint that uses it
  double chi;              ///< χ, 1; −1 < χ ≤ 0
  double beta;             ///< β, 1; ≥ 0
};

/// One of the parts that add up to a density.
using DensityPart =
    std::variant<UniformPart, PowerLawPart, PiecewiseLinearPart, AtomsPart, FourParameterPart>;

/// Partial moments Φn(s) = ∫₀ˢ f*ⁿ φ df*, the atoms at s included.
struct PartialMoments {
  double zeroth = 0.0;  ///< Φ0, 1
  double first = 0.0;   ///< Φ1, N
  double second = 0.0;  ///< Φ2, N²
};

}  // namespace microslip
