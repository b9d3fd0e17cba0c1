// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/io/uff/uff58.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// The header of a dataset 58 as the name and the attributes of a channel, and back. Internal to
/// io.

namespace microslip {

/// The header of a channel of which nothing more is known. Its fields are no attributes of a
/// channel that is read; all others are, by name: "id line 1", "function type", "response node", …
[[nodiscard]] Uff58Header usual_uff58_header(const Dimension& axis,
                                             const std::optional<Dimension>& values,
                                             bool is_complex);

/// Attributes that differ from the usual header, but for points, values and their format.
[[nodiscard]] Attributes uff58_attributes(const Uff58Header& header, const Uff58Header& usual);

/// Sets the field that the attribute is of; attributes of other names and values that the field
/// cannot hold are left out.
void apply_uff58_attributes(const Attributes& attributes, Uff58Header& header);

/// "point 3 +Z", for functions of two points "point 3 +Z / point 1 +X".
[[nodiscard]] std::string uff_point_name(const Uff58Header& header);

/// The names of the channels of a recording: ID line 1 where it is given and no other has it, or
/// else uff_point_name(), with " (2)" where that is there already.
[[nodiscard]] std::vector<std::string> uff_channel_names(std::span<const Uff58Header> headers);

}  // namespace microslip
