// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "microslip/base/summary.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/record_evidence.hpp"
#include "microslip/workflow/compare/comparison.hpp"
#include "microslip/workflow/reduce/force_records.hpp"

/// @file
/// Records of force and displacement of a joint against what the joint predicts.

namespace microslip {

/// The code of a warning: see departures_of().
inline constexpr const char* kTestNotOfThisKind = "test_not_of_this_kind";

/// A joint by itself, with what it loses beside slip.
struct LoopJoint {
  Joint joint;                  ///< F(u)
  double linear_damping = 0.0;  ///< β, J/m²; ≥ 0
  double viscous = 0.0;         ///< c, N s/m; ≥ 0
  std::optional<double> covered_to =
      {};  ///< kA of the largest cycle that it was identified from, N
};

/// Departures of a record from a Masing joint under constant normal load, whatever its density:
/// `test_not_of_this_kind` with those that invert_records() finds in it alone, `departures_unknown`
/// where it cannot be inverted; nothing where there is none.
[[nodiscard]] std::optional<Warning> departures_of(const RecordEvidence& evidence);

/// Predicts the force of the joint on the path of a record, and the losses of its closed cycles
/// (record_cycles()): with A the amplitude of a cycle and T how long it takes
///
///     dissipation [J]           D(A) + βA² + cπ(2π/T)A², as a sine of that amplitude loses
///     secant_stiffness [N/m]    k_eq(A)
///
/// over amplitude [m], and of the whole record, without a measured value,
///
///     force_nrmse [1]           rms(F − F_joint)/rms(F − mean F)
///     force_noise [1]           that of the noise of its samples alone: no joint has
///                               less
///
/// over the samples of which the state of the joint is known; F_joint as found_force(), with the
/// mean of what is measured, without βA², which has no force along a path (warning
/// `linear_damping_left_out`). Warnings also: `beyond_identification`, `no_closed_cycles`, and
/// those of departures_of().
/// @param record  of the joint.
/// @param joint   as it is thought to be.
/// @param draw    draw i of it; empty without draws.
/// @param draws   which of them; nothing without.
/// @throws InputError  as check_force_record(); where the state of the joint is known at no sample.
/// @throws Cancelled   as the progress of the draws says.
[[nodiscard]] ComparedTest compare_loops(const NamedForceRecord& record, const LoopJoint& joint,
                                         const std::function<LoopJoint(std::size_t i)>& draw = {},
                                         const std::optional<TestDraws>& draws = {});

}  // namespace microslip
