// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/io/uff/uff_mode_shape.hpp"

/// @file
/// Mode shapes of whichever dataset. Internal to io.

namespace microslip {

/// Whether the dataset can be one: 55, 2414.
[[nodiscard]] bool has_uff_mode_shape(const UffDataset& dataset);

/// Reads the dataset that is open, all but the line that closes it.
/// @param units     that are before it in the file. @param warnings  gets what is left out.
/// @return nothing where it has no motion of nodes.
/// @throws FormatError  where it has not the form of its number, or ends within it.
[[nodiscard]] std::optional<UffModeShape> read_uff_mode_shape(UffEnvelope& envelope,
                                                              const UffDataset& dataset,
                                                              const std::optional<Uff164>& units,
                                                              std::vector<Warning>& warnings);

}  // namespace microslip
