// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/rig/rig.hpp"
#include "microslip/signal/recording.hpp"

namespace microslip::app {

/// The rig of examples/reference_rig, and its recordings.
[[nodiscard]] Rig demo_rig();
[[nodiscard]] std::vector<Recording> demo_recordings(const Rig& rig);

}  // namespace microslip::app
