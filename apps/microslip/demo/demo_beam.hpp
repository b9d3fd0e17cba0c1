// SPDX-License-Identifier: MIT
#pragma once

#include "demo/demo_folder.hpp"
#include "microslip/identify/methods/identification.hpp"

namespace microslip::app {

/// The part of the demonstration with a measured joint: eight levels of a bolted beam, with the
/// linear damping still in them.
Identification demonstrate_beam(DemoFolder& folder);

}  // namespace microslip::app
