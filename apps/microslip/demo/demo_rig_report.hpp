// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "demo/demo_rig.hpp"

namespace microslip::app {

/// The chain as text for a person: truth beside estimate.
[[nodiscard]] std::string describe_rig(const RigDemonstration& done);

}  // namespace microslip::app
