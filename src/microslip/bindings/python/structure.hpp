// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "microslip/dynamics/jointed_structure.hpp"

namespace microslip::python {

/// A structure is shared by what was made of it, as a joint is.
using SharedStructure = std::shared_ptr<const JointedStructure>;

}  // namespace microslip::python
