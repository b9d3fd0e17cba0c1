// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// The functions of FMI 2.0 in C, to follow the functions of a joint and the definitions of
/// FMU_GUID and JOINT(x), which is NAME_x. Value references are 1 for the displacement
/// and 2 for the force. The positions of the sliders are kept in fmi2CompletedIntegratorStep(),
/// fmi2NewDiscreteStates() and fmi2DoStep(); until then each value is a trial from those kept.
/// With FMI2_OVERRIDE_FUNCTION_PREFIX the names are those of a shared object, else they begin with
/// that of the model. [FMI 2.0.3, 2.1 to 4.2]
[[nodiscard]] std::string_view fmu_code();

}  // namespace microslip
