// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"

/// @file
/// Common to comparisons of tests with a model. Internal to workflow.

namespace microslip {

/// A vibration with two targets: from the first of some near it that leads there, or, where none
/// does, from none.
/// @param starts   in this order; null for one that is not there.
/// @param mode     as in HarmonicBalance::solve().
/// @param failure  gets why there is none, where it has no other reason yet.
/// @return nothing where it was not found.
[[nodiscard]] std::optional<SteadyVibration> vibration_near(
    const HarmonicBalance& balance, const Target& first, const Target& second,
    std::span<const SteadyVibration* const> starts, std::size_t mode, std::string& failure);

/// Of the vibrations with stuck joints the one whose frequency is next to ω by ratio, from 0.
[[nodiscard]] std::size_t nearest_mode(const JointedStructure& structure, double angular_frequency);

/// Of a draw: its accuracy is not what limits a band.
[[nodiscard]] HarmonicBalanceOptions options_of_draws(HarmonicBalanceOptions options);

/// Warnings on predicted motions: add_truncation() and add_model_warnings().
/// @param kept  as there.
[[nodiscard]] std::vector<Warning> motion_warnings(const HarmonicBalance& balance,
                                                   const ModelFile& model, Quantity kept,
                                                   ResponseCurve motions);

}  // namespace microslip
