// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// The attribute of a channel by which a reader says why values are missing: "-3 is the
/// _FillValue". It becomes part of the reason of leave_out_incomplete() and check_recording().
inline constexpr std::string_view kMissingAttribute = "missing";

}  // namespace microslip
