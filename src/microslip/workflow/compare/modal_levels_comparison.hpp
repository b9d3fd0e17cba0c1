// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/observe/modal_levels.hpp"
#include "microslip/workflow/compare/comparison.hpp"
#include "microslip/workflow/reduce/modal_decay.hpp"

/// @file
/// Levels of the modes of a structure, of ring-downs above all, against what its model predicts.

namespace microslip {

/// Modes tracked in a decay, as levels.
[[nodiscard]] ModalLevels levels_of(const ReducedModalDecay& decay);

/// Predicts the nonlinear mode (Forcing::kModal) at each displacement that was measured: frequency
/// [Hz], damping_ratio [1] and dissipation [J] of all joints, those that were measured, over
/// displacement [m]; one test a mode. A mode that no joint takes part in, or each where `forcing`
/// says so, is predicted in phase resonance with the excitation of the model. By a draw of a
/// response that reads g times what is there the displacement is 1/g of the reading, and as far
/// from it as its standard deviation has it. Those of frequency, damping and dissipation are those
/// of readings in compare(). Losses of single joints are not compared.
/// @param source   of the levels, for the table.
/// @param levels   of one mode or several.
/// @param model    whose response point the displacements are of.
/// @param options  of the harmonic balance; its forcing is not looked at.
/// @param spread   of the model; nothing without draws.
/// @param draws    which of them; nothing without.
/// @param forcing  what drove the levels: kModal nothing, as in a ring-down.
/// @param std_freedom  of the estimate that all standard deviations are, see ComparedCurve.
/// @throws InputError  as HarmonicBalance and compare(); where no level has one of the three.
/// @throws Cancelled   as the progress of the draws says.
[[nodiscard]] std::vector<ComparedTest> compare_modal_levels(
    const std::string& source, const ModalLevels& levels, const ModelFile& model,
    const HarmonicBalanceOptions& options, const std::optional<StructureDraws>& spread = {},
    const std::optional<TestDraws>& draws = {}, Forcing forcing = Forcing::kModal,
    std::size_t std_freedom = 0);

}  // namespace microslip
