// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/identify/posterior/density_posterior.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// Results of invert() as joints.

namespace microslip {

/// The joint of a result of invert().
/// @param result     with its atom, where it has one.
/// @param stiffness  k of the inversion, N/m.
[[nodiscard]] Joint joint_of(const InversionResult& result, double stiffness);

/// Draws of its posterior as joints.
/// @param result     whose posterior was drawn.
/// @param samples    of its posterior.
/// @param stiffness  k, N/m.
[[nodiscard]] std::vector<Joint> drawn_joints(const InversionResult& result,
                                              std::span<const DensitySample> samples,
                                              double stiffness);

}  // namespace microslip
