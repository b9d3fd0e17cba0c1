// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/identify/inversion.hpp"
#include "microslip/identify/inversion_model.hpp"
#include "microslip/identify/smoothing_path.hpp"

/// @file
/// The passes of the inversion before edges are sought. Internal: Eigen stays out of the installed
/// headers.

namespace microslip {

/// What a pass assumed, and what it found.
struct PassedModel {
  PassOptions pass;
  InversionModel model;
};

/// A first pass with rough weights, then the one that counts: its weights, reference and penalty
/// come from the first. A third would change nothing. λ is chosen in both.
/// @param top    where the density ends, as PassOptions has it.
/// @param atom   at the top.
/// @param inner  told of all solutions.
[[nodiscard]] PassedModel two_passes(const ScaledLevels& levels, const InversionOptions& options,
                                     double top, bool atom, InnerSolutions& inner);

}  // namespace microslip
