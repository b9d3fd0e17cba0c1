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

/// Points of a curve, in its order.
struct Curve {
  std::vector<double> x;  ///< one length
  std::vector<double> y;  ///< one an x
};

/// D, D′, k_eq or η of a joint at an amplitude: dissipation(), dissipation_slope(),
/// secant_stiffness(), loss_factor().
using JointQuantity = double (*)(const Joint&, double);

/// The quantity + βA² at amplitudes.
/// @param amplitude       A, m; ≥ 0.
/// @param linear_damping  β, J/m², of a dissipation.
[[nodiscard]] std::vector<double> joint_curve(const Joint& joint, JointQuantity quantity,
                                              const std::vector<double>& amplitude,
                                              double linear_damping = 0.0);

/// φ without the atoms at even steps; where it is infinite there is no point.
struct DensityPoints {
  std::vector<double> slip_force;  ///< N
  std::vector<double> density;     ///< 1/N
};

/// At a step the density is the one above it; at `to` the one below it, where identified ones end.
[[nodiscard]] DensityPoints density_points(const Joint& joint, double from, double to);

/// Φ0(f*), 1, over slip forces from 0, N: so many steps that those at atoms look upright.
[[nodiscard]] Curve slipped_share(const Joint& joint, double to);

/// A steady loop: from A down and up again, without the point at which it closes.
struct SteadyLoop {
  std::vector<double> displacement;  ///< m
  std::vector<double> force;         ///< N
};

/// @param amplitude  A, m; > 0. @param half  points of a branch.
[[nodiscard]] SteadyLoop steady_loop(const Joint& joint, double amplitude, std::size_t half = 160);

/// F − F_base at the same displacements, N. @param loop, base  of one amplitude and length.
[[nodiscard]] std::vector<double> force_difference(const SteadyLoop& loop, const SteadyLoop& base);

/// The amplitudes whose loops are shown, m: the largest and three parts of it.
[[nodiscard]] std::vector<double> loop_amplitudes(double largest);

}  // namespace microslip
