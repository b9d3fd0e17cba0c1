// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/joint/joint.hpp"

/// @file
/// Points of curves, for figures and tables.

namespace microslip {

/// x in equal ratios; about `from` where `to` is hardly larger, so that a curve has a length.
/// @param count  ≥ 2.
[[nodiscard]] std::vector<double> equal_ratios(double from, double to, std::size_t count = 160);

/// φ without the atoms at even steps; where it is infinite there is no point.
struct DensityPoints {
  std::vector<double> slip_force;  ///< N
  std::vector<double> density;     ///< 1/N
};

/// At a step the density is the one above it; at `to` the one below it, where identified ones end.
[[nodiscard]] DensityPoints density_points(const Joint& joint, double from, double to);

/// A steady loop: from A down and up again, without the point at which it closes.
struct SteadyLoop {
  std::vector<double> displacement;  ///< m
  std::vector<double> force;         ///< N
};

/// @param amplitude  A, m; > 0. @param half  points of a branch.
[[nodiscard]] SteadyLoop steady_loop(const Joint& joint, double amplitude, std::size_t half = 160);

}  // namespace microslip
