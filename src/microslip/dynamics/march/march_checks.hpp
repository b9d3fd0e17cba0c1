// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/dynamics/march/load_history.hpp"
#include "microslip/dynamics/march/march_options.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// The rules that march() has for what it is given, the length of the chosen step but left out.
/// Internal to dynamics. @throws InputError  naming what breaks one.
void check_march(const JointedStructure& structure, const LoadHistory& loads,
                 const MarchOptions& options);

}  // namespace microslip
