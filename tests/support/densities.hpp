// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/observe/levels.hpp"

/// @file Known joints to identify, levels "measured" on them, and how far an answer is from the
/// truth. All have k = 1.7e5 N/m, and the levels go to 3e-4 m, so that data reach f* = 51 N.

namespace microslip::testing {

inline constexpr double kStiffness = 1.7e5;                       ///< N/m
inline constexpr double kLowestAmplitude = 2.13e-6;               ///< m
inline constexpr double kLargestAmplitude = 3e-4;                 ///< m
inline constexpr double kReach = kStiffness * kLargestAmplitude;  ///< N

Joint joint_of(std::vector<DensityPart> parts);

/// A density of any shape, sampled at knots that crowd towards 0 (linear between them, and that is
/// then the truth), and scaled to an area.
Joint sampled_joint(const std::function<double(double)>& shape, double to, double area);

double bell(double x, double centre, double width);

/// The joint of the reference rig: two broad populations, area 1 up to 75 N.
Joint reference_joint();

/// Two populations with an empty range between them.
Joint two_gaussians();

Joint two_lognormals();

/// A power law that a Gaussian cuts off, and a second population.
Joint cut_power_law_and_bump();

Joint uniform_beyond_range();

Joint uniform_to_range_end();

/// φ ∝ f*^−½ up to 60 N.
Joint power_law();

/// φ ∝ f*^−0.3 exp(−f*/30 N).
Joint decaying_power_law();

/// φ ∝ f* exp(−f*/9 N): nothing slips at first.
Joint gamma_density();

/// A ramp that ends at once.
Joint ramp();

/// Little of the joint slips, most of it at small forces.
Joint faint_lognormal();

/// φ ∝ f*^−0.7 with three narrow populations on it.
Joint power_law_and_three_bumps();

struct NamedJoint {
  std::string name;
  Joint joint;
};

/// Densities that no method, option or bound of the identification was chosen on, and none may be:
/// they show how the figures of the others carry over. One thing was: that the smoothness of the
/// posterior changes along the density (LocalSmoothing), for the peaks of the last one.
std::vector<NamedJoint> unseen_truths();

std::vector<NamedJoint> all_truths();

Levels levels_at(const Joint& joint, const std::vector<double>& amplitudes);

std::vector<double> equal_steps(std::size_t count, double from = kLowestAmplitude,
                                double to = kLargestAmplitude);

std::vector<double> equal_ratios(std::size_t count, double from, double to);

/// 90 levels in equal steps, without noise.
Levels exact_levels(const Joint& joint);

/// Relative noise on D, without standard deviations.
void add_noise(Levels& levels, double relative, std::uint64_t draw);

/// Secant stiffness with relative noise, without standard deviations.
void add_secant(const Joint& joint, double relative, std::uint64_t draw, Levels& levels);

Levels noisy_levels(const Joint& joint, std::uint64_t draw, double relative = 0.01);

/// φ between knots: linear; 0 beyond the last.
double density_at(const std::vector<double>& slip_force, const std::vector<double>& density,
                  double f);

/// ‖φ − φ_true‖/‖φ_true‖ over 5 to 95 % of `reach`, at 2001 points.
double density_error(const std::vector<double>& slip_force, const std::vector<double>& density,
                     const Joint& truth, double reach = kReach);

double median(std::vector<double> values);

}  // namespace microslip::testing
