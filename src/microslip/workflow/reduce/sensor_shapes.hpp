// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/signal/decay/shape_course.hpp"

/// @file
/// How the shape of a mode moves at a point while joints slip. Internal to workflow.

namespace microslip {

/// The course of a mode's shape at a point over its frequency, while all joints lose the same share
/// of their stiffness. The standard deviation of its slope is a fifth of the slope, for what a
/// linear structure of softer joints misses of one whose joints slip, and, of several joints, the
/// scatter among the courses in which one alone loses stiffness, each weighted by how much of the
/// change of frequency it can explain.
/// Empty where no joint moves the frequency, or the point does not move in the mode.
/// @param mode   by frequency with stuck joints, from 0.
/// @param point  of the structure's modal model: its shape φ_i.
[[nodiscard]] ShapeCourse shape_course(const JointedStructure& structure, std::size_t mode,
                                       std::span<const double> point);

}  // namespace microslip
