// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// Record of a steady vibration by the sensors of a rig: the force, the accelerations and, where
/// the rig has a vibrometer, u or u − Σψ_i q_i (for a beam u − r w′(L), the axial motion of its
/// centre line [AR14 (13)]), sampled as given in the test, each sample with the noise of the rig.
/// The phase at which the record begins is drawn.
///
/// Record r of a seed takes its phase from stream 2¹⁶ r of RandomStream and the noise of channel c,
/// from 0, from stream 2¹⁶ r + 1 + c, so that it does not depend on other records.
/// @param rig     with a test.
/// @param state   of this rig.
/// @param driven  of a structure with these modes.
/// @param seed    of all records of a test.
/// @param record  r, see record_number().
/// @throws InputError  as check_rig(), for longer records than it lets keep too, and where the rig
///                     has no test.
[[nodiscard]] Recording virtual_record(const Rig& rig, const StickState& state,
                                       const DrivenVibration& driven, std::uint64_t seed,
                                       std::uint64_t record);

/// r of the records of a test, so that each is the same whatever else is recorded: 2(l − 1) for the
/// controlled state of level l, from 1, and 2(l − 1) + 1 for the one before control.
[[nodiscard]] std::uint64_t record_number(const VirtualLevel& level, bool before_control = false);

}  // namespace microslip
