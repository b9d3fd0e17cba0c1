// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/identify/methods/identification.hpp"

/// @file
/// The draws behind a band, as joints to be kept.

namespace microslip {

/// @param found       from levels with a band, or from records.
/// @param provenance  of the draws, with their seed.
/// @throws InputError  where nothing was drawn.
[[nodiscard]] JointSamples joint_samples(const Identification& found, const Provenance& provenance);

}  // namespace microslip
