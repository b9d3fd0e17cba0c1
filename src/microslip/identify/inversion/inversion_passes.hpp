// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/identify/inversion/inversion_model.hpp"
#include "microslip/identify/inversion/inversion_options.hpp"
#include "microslip/identify/smoothing/smoothing_path.hpp"

/// @file
/// The passes of the inversion before edges are sought, and the steps of a pass. Internal: Eigen
/// stays out of the installed headers.

namespace microslip {

/// Points of a path that is computed for its weights or its likelihood alone.
inline constexpr std::size_t kFirstPassPoints = 25;

/// The scatter, in units of 1/W, estimated from the residual of a solution and repeated levels.
struct PathScatter {
  double value;
  double degrees_of_freedom;
};

/// @param residual  weighted squared residual of a solution.
/// @param edf       its effective degrees of freedom.
[[nodiscard]] PathScatter estimate_scatter(const InversionModel& model, double residual,
                                           double edf);

/// Sets the scatter of D and of k_eq, each over that of both, from the residual and the degrees of
/// freedom of each kind of rows.
void separate_scatter(InversionModel& model, const ScaledLevels& levels);

/// Computes so many points of the λ path, and chooses one of them, or λ of the options.
/// @param inner  counts all solutions.
void run_path(InversionModel& model, const InversionOptions& options, std::size_t points,
              InnerSolutions& inner);

/// Assumptions and result of a pass.
struct PassedModel {
  PassOptions pass;
  InversionModel model;
};

/// A first pass with rough weights, then the final one: its weights, reference and penalty come
/// from the first. A third would not change the result. λ is chosen in both.
/// @param top    where the density ends, as PassOptions has it.
/// @param atom   at the top.
/// @param inner  counts all solutions.
[[nodiscard]] PassedModel two_passes(const ScaledLevels& levels, const InversionOptions& options,
                                     double top, bool atom, InnerSolutions& inner);

}  // namespace microslip
