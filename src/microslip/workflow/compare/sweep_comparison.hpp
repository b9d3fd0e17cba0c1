// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/rig/reduction/stepped_sine.hpp"
#include "microslip/workflow/compare/comparison.hpp"

/// @file
/// Stepped-sine sweeps of a structure against what its model predicts.

namespace microslip {

/// kSweep or kConstantResponse: whichever of force and acceleration was kept more constant, by the
/// ratio of its largest to its smallest value. @throws InputError  as check_stepped_sine().
[[nodiscard]] TestKind kind_of(const SteppedSine& sweep);

/// Predicts each step of a sweep at the frequency that it had and, of kSweep, at the force that was
/// measured there, of kConstantResponse at the response; so that a force that varied, as about a
/// resonance, is no error of the prediction. Curves, with X = a/ω² the displacement of what was
/// measured:
///
///     displacement [m], or force [N]     over the frequency, of the steps
///     phase_lag [rad]                    of the displacement behind the force, in [0, π]
///     the first, frequency [Hz] and damping_ratio [1] at the peak: in phase resonance, of what was
///                                        measured by resonance_of(), predicted at its force or
///                                        response
///
/// Those at the peak have the standard deviations of resonance_of(): that of |F_1|/|A_1| is also
/// that of the displacement at a force, for which it is the most that it can be: 1/(1 + p) of it
/// where D grows with X^{2+p}.
///
/// The damping ratio that is measured is that of the force F that feeds X in phase resonance, by
/// the shape φ of the motion that the model has at X,
///
///     ζ = F X_d/(2 ω² Σ|q_i|²) = c F/ω²,
///
/// X_d and q_i of drive point and modes in the model's motion with the measured X; it is predicted
/// at X. Steps are solved one from the other in the order of the sweep, so that of several
/// vibrations the one counts that it leads to.
///
/// The sign of a phase, and whether it is that of the displacement or of an acceleration that is
/// positive against the force, are conventions: |phase| or π − |phase| is taken, whichever is
/// nearer to the prediction, and `note` tells which.
///
/// By a draw what would be read: a force reading F drives with F/g, of a response g times what is
/// there is read. Warnings: those of the model for such motions (`beyond_identification`,
/// `truncated`, …), `no_resonance` where the phase of the sweep does not pass a quarter turn, those
/// of the resonance, warnings_of(), `no_mode_in_sweep` where the predicted lag does not pass it:
/// the model has no resonance at the steps.
/// @param sweep    measured at the response point of the model.
/// @param kind     kSweep or kConstantResponse: see kind_of().
/// @param model    driven by a force.
/// @param options  of the harmonic balance; forcing is that of the model.
/// @param spread   of the model; nothing without draws.
/// @param draws    which of them; nothing without.
/// @throws InputError  as resonance_of(), HarmonicBalance and compare(); for a model whose base
///                     is driven. @throws Cancelled  as the progress of the draws says.
[[nodiscard]] ComparedTest compare_sweep(const SteppedSine& sweep, TestKind kind,
                                         const ModelFile& model,
                                         const HarmonicBalanceOptions& options,
                                         const std::optional<StructureDraws>& spread = {},
                                         const std::optional<TestDraws>& draws = {});

}  // namespace microslip
