// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/signal/decay/shape_course.hpp"

/// @file
/// How the shapes of modes move at points while joints slip. Internal to workflow.

namespace microslip {

/// How much a place moves in a shape, whatever its sign. @param place  its φ_i, one per mode q_i.
[[nodiscard]] double motion_at(std::span<const double> shape, std::span<const double> place);

/// The courses of the shapes of all vibrations at points over their frequencies, while all joints
/// lose the same share of their stiffness. The standard deviation of a slope is a fifth of the
/// slope, for what a linear structure of softer joints misses of one whose joints slip, and, of
/// several joints, the scatter among the courses in which one alone loses stiffness, each weighted
/// by how much of the change of frequency it can explain.
/// @param points  of the structure's modal model: the shape φ_i of each.
/// @return  of each vibration, by frequency with stuck joints, that at each point; empty where no
///          joint moves the frequency, or the point does not move in the mode.
[[nodiscard]] std::vector<std::vector<ShapeCourse>> shape_courses(
    const JointedStructure& structure, std::span<const std::span<const double>> points);

}  // namespace microslip
