// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/uff/uff58_header.hpp"
#include "microslip/io/uff/uff_envelope.hpp"

/// @file
/// Dataset 58, "function at nodal degree of freedom", as text and, 58b, with binary values. Values
/// and units are as in the file. Internal to io.

namespace microslip {

/// Reads the dataset that is open and closes it. Where `header.points` is less than it announced,
/// there is a warning.
/// @throws UffTruncated  where values are missing and `allow_truncated` is false.
[[nodiscard]] Uff58 read_uff58(UffEnvelope& envelope, const UffDataset& dataset,
                               bool allow_truncated, std::vector<Warning>& warnings);

// ---- Steps of read_uff58(). ----

[[nodiscard]] Uff58Header read_uff58_header(UffEnvelope& envelope, std::vector<Warning>& warnings);

/// Fills x, values and imaginary; fewer points than announced where the dataset ends before.
void read_uff58_text_values(UffEnvelope& envelope, Uff58& data, std::vector<Warning>& warnings);
void read_uff58_binary_values(UffEnvelope& envelope, const UffDataset& dataset, Uff58& data,
                              bool allow_truncated, std::vector<Warning>& warnings);

}  // namespace microslip
