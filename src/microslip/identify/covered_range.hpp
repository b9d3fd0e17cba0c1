// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/covered_range.hpp"

/// @file
/// For programs that include beyond_identification() by the name that its header had.
