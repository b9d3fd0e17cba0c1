// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Dataset 151, "header". Internal to io.

namespace microslip {

/// "model name", "model description", "creating program", "created": those that are given. Records
/// that are missing are no error.
[[nodiscard]] Attributes read_uff151(UffEnvelope& envelope);

/// With the attributes of these names; others have no place in it.
[[nodiscard]] std::string format_uff151(const Attributes& attributes);

}  // namespace microslip
