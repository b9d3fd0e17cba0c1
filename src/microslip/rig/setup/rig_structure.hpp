// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <optional>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"

namespace microslip {

/// The name of the joint in rig_structure().
inline constexpr std::string_view kContact = "contact";

/// The modes of a test's stick state, with points that carry the names of the channels there: that
/// of the force for the exciter, those of the accelerometers.
/// @param rig    a test.
/// @param state  of this rig.
/// @throws InputError  as ModalModel.
[[nodiscard]] ModalModel rig_modes(const Rig& rig, const StickState& state);

/// The structure of a test with a joint in its contact, for prediction: the modes of its stick
/// state, rig_modes(), with hysteretic damping as in the reduction, and the joint with the
/// shortening and the axial compliance [AR14 (12) (13)].
/// @param rig    a test.
/// @param state  of this rig.
/// @param joint  its stiffness may differ from the rig's k: the spring in the modes, which is
///               subtracted, is the rig's; for modes of a rig without k, that of the joint.
/// @param force  s_1, s_2, …, 1: see Excitation.
/// @param linear_damping  β of the joint, J/m²: see StructuralJoint. The loss factors of the rig
///                        remain, as the reduction had subtracted their loss when β was identified.
/// @throws InputError  as JointedStructure.
[[nodiscard]] JointedStructure rig_structure(const Rig& rig, const StickState& state, Joint joint,
                                             std::vector<std::complex<double>> force = {1.0},
                                             double linear_damping = 0.0);

/// A warning, `stiffness_differs`, where the stiffness of a joint and k of the rig differ by more
/// than 1 %: the modes are then those of another stuck state, and so are its frequencies.
[[nodiscard]] std::optional<Warning> stiffness_warning(const StickState& state, const Joint& joint);

}  // namespace microslip
