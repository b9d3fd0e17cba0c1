// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/rig/setup/rig.hpp"

/// @file
/// rig.toml, schema microslip.rig/1: a frictional-support test. Values are SI, their keys end in
/// the unit.
///
///     schema = "microslip.rig/1"
///     [beam]            length_m, width_m, thickness_m, youngs_modulus_Pa, mass_density_kg_per_m3
///     [contact]         rod_radius_m, stiffness_N_per_m or stick_frequency_Hz, joint (optional)
///     [damping]         loss_factor = […]
///     [[mass]]          position_m, mass_kg; any number of them
///     [excitation]      position_m, channel
///     [[accelerometer]] position_m, channel; at least one
///     [vibrometer]      channel, measures = "joint" or "axial"; optional
///     [test]            response_acceleration = { from_m_per_s2, to_m_per_s2, count,
///                       spacing = "linear" or "log" }, sampling_rate_Hz, duration_s and, optional,
///                       frequency_resolution_Hz, modes, harmonics; optional
///     [noise]           force_N, acceleration_m_per_s2, vibrometer_m, each optional; optional
///     [shaker]          resistance_Ohm, inductance_H, force_factor_N_per_A, moving_mass_kg,
///                       suspension_stiffness_N_per_m, suspension_damping_Ns_per_m,
///                       stinger_stiffness_N_per_m, each optional; optional
///
/// With `[modes] frequency_Hz, excitation, joint` in place of [beam] an accelerometer has `shape`
/// and no position, the excitation only its channel, and the contact, then optional, no rod; there
/// are no masses. What is optional and left out has the default of Rig.

namespace microslip {

/// A rig and the file that it comes from: the paths in it are relative to the folder of that.
struct RigFile {
  Rig rig;           ///< as described
  std::string file;  ///< its path
};

/// contact.joint is the path as written.
/// @throws FormatError  for text that is no TOML, another schema, keys unknown or missing.
/// @throws InputError   naming `rig.toml:12:3: accelerometer[1].position_m` for a value of a
///                      wrong type or one that breaks a rule of check_rig().
[[nodiscard]] Rig parse_rig(std::string_view text, std::string_view file);

/// The key of rig.toml for a field that an error of a rig names: `test.sampling_rate` is
/// `test.sampling_rate_Hz` there. Another name stays as it is.
[[nodiscard]] std::string rig_key(const std::string& field);

/// parse_rig() of a file; "-" is standard input. @throws FileError, FormatError, InputError
[[nodiscard]] Rig read_rig(const std::string& path);

}  // namespace microslip
