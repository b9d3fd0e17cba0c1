// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/signal/decay/ring_down.hpp"

/// @file
/// Texts on a decay. Internal to workflow.

namespace microslip {

/// The codes, between blanks, of what holds for the whole decay: what single levels say of
/// themselves is among their own flags.
[[nodiscard]] std::string codes_of_decay(const std::vector<Warning>& warnings);

/// When free decay begins, and how that was found.
[[nodiscard]] std::string decay_start_text(const RingDown& decay);
/// LOW:HIGH, and whence. @param given  by the caller.
[[nodiscard]] std::string decay_band_text(const RingDown& decay, bool given);
/// Those used, with their ratios of amplitude.
[[nodiscard]] std::string decay_sensors_text(const RingDown& decay);

}  // namespace microslip
