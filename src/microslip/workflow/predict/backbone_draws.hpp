// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// Draws of a model through its backbone.

namespace microslip {

/// Band of a backbone from draws of a model, one value per point of it.
struct BackboneSpread {
  Band force;                     ///< N
  Band frequency;                 ///< Hz
  Band damping_ratio;             ///< 1
  DrawsTaken taken;               ///< what became of the draws
  std::vector<Warning> warnings;  ///< what must be known of the bands
};

/// Backbone of one draw, one value per point of the reference.
struct DrawnBackbone {
  std::string failure = {};                ///< why there is none; empty where there is
  std::vector<double> force = {};          ///< N
  std::vector<double> frequency = {};      ///< Hz
  std::vector<double> damping_ratio = {};  ///< 1
};

/// Resonances of a draw, as backbone_spread() takes them.
/// @param balance, reference, responses, mode  as there.
/// @param drawn  a structure as it may be.
/// @throws InputError  as HarmonicBalance of it.
[[nodiscard]] DrawnBackbone drawn_backbone(const HarmonicBalance& balance,
                                           const ResponseCurve& reference,
                                           const std::vector<double>& responses, std::size_t mode,
                                           StructureDraw drawn);

/// Resonances of each draw at the responses of the reference, as they are read. A draw fails where
/// its curve does not have them all, or turns back so that it has other rows.
/// @param balance    of the reference: response point and options are those of the draws.
/// @param reference  its resonances() at the responses, converged.
/// @param responses  that it was made for, in the kind of the response point.
/// @param mode       from 0.
/// @param draws      of the model.
/// @param options    which of them, and the confidence.
/// @param execution  of the draws.
/// @param progress   reports the number done; may cancel.
/// @throws InputError  where all draws failed, or as DrawOptions::check().
/// @throws Cancelled   as progress says.
[[nodiscard]] BackboneSpread backbone_spread(const HarmonicBalance& balance,
                                             const ResponseCurve& reference,
                                             const std::vector<double>& responses, std::size_t mode,
                                             const StructureDraws& draws,
                                             const DrawOptions& options,
                                             const Execution& execution = Execution::threads(),
                                             const Progress& progress = {});

}  // namespace microslip
