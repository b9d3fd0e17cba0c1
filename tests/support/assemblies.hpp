// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/base/interpolation.hpp"
#include "microslip/base/random.hpp"
#include "microslip/identify/assemblies/assemblies.hpp"
#include "support/densities.hpp"

/// @file Assemblies of a known joint, which differ by known spreads, and levels "measured" on them.

namespace microslip::testing {

/// Standard deviations of logarithms.
struct KnownSpread {
  double stiffness = 0.05;
  double slip_force = 0.15;
  double shape = 0.15;
};

/// An assembly of a joint: φ_j(f) = φ(f/S)/S · e^g(f/S) with g = c₀ + c₁cos πt + c₂sin πt, t the
/// root of f over the end of the density: not what the identification assumes of shapes, but as
/// smooth.
Joint assembly_of(const Joint& middle, const KnownSpread& spread, std::uint64_t seed,
                  std::uint64_t number);

/// Levels of a campaign: D of `count` levels from 5 % of the largest amplitude, with scatter.
Levels measured_levels(const Joint& joint, std::size_t count, double scatter, std::uint64_t seed,
                       std::uint64_t number);

/// Assemblies numbered from 0, named "a", "b", …, with k given.
std::vector<Assembly> measured_assemblies(const Joint& middle, const KnownSpread& spread,
                                          std::size_t count, std::uint64_t seed,
                                          std::size_t levels = 30, double scatter = 0.01);

}  // namespace microslip::testing
