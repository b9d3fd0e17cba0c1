// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/io/uff/uff_mode_shape.hpp"

/// @file
/// One dataset 2414, "analysis data". Internal to io.

namespace microslip {

/// Reads the lines of the dataset that is open, all but the one that closes it.
/// @param warnings  gets what is left out, by name.
/// @return nothing where it has no motion of nodes: stresses, forces, values on elements.
/// @throws FormatError  where it is no dataset 2414, ends before it does, or has motions of nodes
///                      in a form that is not read.
[[nodiscard]] std::optional<UffModeShape> read_uff2414(UffEnvelope& envelope,
                                                       std::vector<Warning>& warnings);

}  // namespace microslip
