// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/io/uff/uff_mode_shape.hpp"

/// @file
/// One dataset 55. Internal to io.

namespace microslip {

/// Reads the lines of the dataset that is open, all but the one that closes it.
/// @throws FormatError  where they are no dataset 55, or end before it does.
[[nodiscard]] UffModeShape read_uff55(UffEnvelope& envelope);

}  // namespace microslip
