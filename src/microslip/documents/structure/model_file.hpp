// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/documents/structure/model_contents.hpp"

/// @file
/// model.toml, schema microslip.model/1: a structure with joints, for the prediction of its
/// vibration. Values are SI, their keys end in the unit; shapes are mass-normalised, in kg^−½, one
/// value a mode.
///
///     schema = "microslip.model/1"
///     [structure]       frequency_Hz = […], of the linear part; damping_ratio = […] (viscous
///                       damping, ζ = η/2) or loss_factor = […] (hysteretic, η), one per mode or
///                       one for all
///     [[structure.point]] name, shape = […]; at least one
///     [[structure.base]] name, participation = […] (Γ, kg^½, one per mode), point_motion = […]
///                       (one per point): supports that an excitation accelerates; optional
///     [structure.residual] points = […] and joints = […], names of those with flexibility of the
///                       modes left out, and compliance_m_per_N = […], by rows, points first; see
///                       ResidualFlexibility; optional. static_attachments in [structure]: so many
///                       of the modes, the last, hold that already; 0 where none is left out
///     [[joint]]         file, shape = […]: of the relative displacement across the joint; in place
///                       of file stiffness_N_per_m (k) for a joint still to be identified;
///                       optional: name, spring_in_modes_N_per_m, series_compliance_m_per_N,
///                       shortening_per_kg_m = […] (Γ by rows), linear_damping_J_per_m2 (β; without
///                       the key that of the joint file's identification); any number of them, also
///                       none
///     [excitation]      point, or base; optional: harmonics = […] (amplitude of harmonic n over
///                       the force amplitude) and phase_rad = […] (its phase, a lead); or several
///                       as [[excitation]]; optional channel: that of the force in recordings
///     [[static_load]]   point and force_N, or base and acceleration_m_per_s2; optional
///     [response]        point; optional, else that of the first excitation
///     [[accelerometer]] channel, point: of recordings of the structure; optional
///
/// How uncertain it is, all optional, see StructureSpread: frequency_std and loss_factor_std in
/// [structure], one per mode or one for all; normal_load_std of a [[joint]]; gain_std of an
/// [excitation] and of the [response]. `samples` of a [[joint]] is a joint_samples.h5, relative to
/// the folder of the model: its draws, which are not read here.
///
/// `file` is a joint.json, relative to the folder of the model. A joint without a name is called
/// "joint", or by its number "joint1", "joint2", … where there are several. StructuralJoint and
/// Excitation say what the values mean and which they have where they are left out.

namespace microslip {

/// Reads the joint files too.
/// @param text  the file's whole text.
/// @param file  its folder is where those are sought; the current one where it has none.
/// @param to_find  whether joints may have a stiffness in place of a file.
/// @throws FormatError  for text that is no TOML, another schema, keys unknown or missing; for a
///                      joint file as parse_joint(); for a joint to be found where that is refused.
/// @throws InputError   naming `model.toml:12:3: joint[1].shape` for a value of a wrong type or one
///                      that breaks a rule; for a joint file as parse_joint().
/// @throws FileError    naming `model.toml:12:3: joint[1].file` where that cannot be read.
[[nodiscard]] ModelFile parse_model(std::string_view text, std::string_view file,
                                    JointsToFind to_find = JointsToFind::kRefused);

/// parse_model() of a file; "-" is standard input. @throws FileError, FormatError, InputError
[[nodiscard]] ModelFile read_model(const std::string& path,
                                   JointsToFind to_find = JointsToFind::kRefused);

}  // namespace microslip
