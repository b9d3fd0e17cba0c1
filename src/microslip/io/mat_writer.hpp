// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/signal/recording.hpp"

namespace microslip {

enum class MatVersion { k5, k73 };

/// write_recordings_mat() in a version of choice.
void write_mat(const std::string& path, std::span<const Recording> recordings, MatVersion version);

}  // namespace microslip
