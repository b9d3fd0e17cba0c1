// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/calibrate/calibration_options.hpp"
#include "microslip/calibrate/calibration_result.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/observe/modal_levels.hpp"

namespace microslip {

/// Finds the stiffness densities of several joints of a structure at once from levels of its modes.
/// Per level
///
///     Σ_j D_j(a_j) = ΣD,   D_j(a) = 4∫₀^a x*(a − x*) ψ_j dx*
///
/// and its frequency are linear in all ψ_j once the amplitudes a_j are known; they come from a
/// sensor, or from the structure with the joints found so far, at resonance at the displacement
/// measured. As shapes change when joints slip, the two are found together: Gauss–Newton steps with
/// the derivatives of the resonance (level_sensitivity), over levels whose range grows from those
/// at which the joints hardly slip.
///
/// Prior and posterior as invert_records(): roughness of each ψ_j with a λ of its own, drawn with
/// the scatter of losses and frequencies. The draws are of the problem linear about the solution,
/// the estimate is their mean.
/// @param structure  with all joints; with springs without slip for the joints sought.
/// @param sought     their indices; not empty.
/// @param response   the point where the displacements of the levels were measured.
/// @param levels     at least kFewestModalLevels.
/// @param options    how it is solved.
/// @throws InputError  naming the joint, level or option that breaks a rule.
/// @throws Cancelled   when the progress callback returns false.
[[nodiscard]] CalibrationResult calibrate(const JointedStructure& structure,
                                          const std::vector<std::size_t>& sought,
                                          const std::string& response, const ModalLevels& levels,
                                          const CalibrationOptions& options = {});

/// Returns the levels, from 0, whose loss deviates far more than the scatter of the losses: beyond
/// what one calibration in a thousand has by chance. None where the densities have half as many
/// degrees of freedom as there are levels.
[[nodiscard]] std::vector<std::size_t> loss_outliers(const CalibrationResult& result);

/// Warnings of a calibration:
///   * `levels_not_found`      the structure has no resonance at the displacement of a level;
///   * `known_only_together`   two joints contribute alike to all levels;
///   * `joint_not_seen`        the levels hardly determine a joint, or its loss is not
///                             distinguishable from 0 in any of them;
///   * `loss_uncertain`        the band of the loss of a joint is wide where it has a share of all;
///   * `frequency_offset`      the modes of the structure deviate by more than joints explain;
///   * `offsets_differ`        the modes without joints deviate by different shares;
///   * `frequency_unexplained` frequencies scatter about those of the identified joints by more
///                             than their accuracy;
///   * `scatter_large`         losses scatter about the fit more than a usable measurement, or than
///                             stated;
///   * `level_outlier`         the loss of a level deviates far more than the scatter of the
///                             others;
///   * `std_ignored`           standard deviations given for some levels, or some losses, only;
///   * `sensor_contradicts`    a joint moves differently from its sensor.
/// @param result  of calibrate(). @param levels  that were calibrated.
/// @param names   of these: see CalibrationOptions::level_names.
[[nodiscard]] std::vector<Warning> diagnose(const CalibrationResult& result,
                                            const ModalLevels& levels,
                                            const std::vector<std::string>& names = {});

}  // namespace microslip
